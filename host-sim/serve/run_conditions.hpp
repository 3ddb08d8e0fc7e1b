#pragma once

#include <string>
#include <string_view>

#include "firmware/machine/machine.hpp"
#include "host-sim/serve/served_job.hpp"

namespace sim {

/// Returns what a job has to wait for before it may begin, worded to follow "waits for"; empty if
/// it may begin. All code that needs this decision calls this function: the page shows the result,
/// and POST /job/run answers with it.
/// @param sender_kind the sender that controls the machine, see Reception::sender_kind()
[[nodiscard]] std::string awaited_by_run(const ServedJob& job,
                                         std::string_view sender_kind,
                                         const cnc::Machine& machine);

/// Returns what an interrupted job has to wait for before it may be resumed, in the same form as
/// awaited_by_run(). An alarm does not prevent resuming if the machine's position is known: the
/// machine is unlocked.
[[nodiscard]] std::string awaited_by_resume(const ServedJob& job,
                                            std::string_view sender_kind,
                                            const cnc::Machine& machine);

}  // namespace sim
