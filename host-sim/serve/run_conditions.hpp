#pragma once

#include <string>
#include <string_view>

#include "firmware/machine/machine.hpp"
#include "host-sim/serve/served_job.hpp"

namespace sim {

/// Returns the condition for which a job has to wait before it may begin, as words that follow
/// "waits for"; empty if it may begin. The page shows these words, and POST /job/run answers with
/// them.
/// @param sender_kind the sender that controls the machine, see Reception::sender_kind()
[[nodiscard]] std::string awaited_by_run(const ServedJob& job,
                                         std::string_view sender_kind,
                                         const cnc::Machine& machine);

/// Returns the condition for which an interrupted job has to wait before it may be resumed, in the
/// form of awaited_by_run(). An alarm is no such condition, because resuming unlocks the machine if
/// its position is known.
[[nodiscard]] std::string awaited_by_resume(const ServedJob& job,
                                            std::string_view sender_kind,
                                            const cnc::Machine& machine);

}  // namespace sim
