#pragma once

#include <string>
#include <string_view>

#include "firmware/machine/machine.hpp"
#include "host-sim/serve/served_job.hpp"

namespace sim {

/// For what a job waits before it may begin, after "waits for"; empty for nothing. The one place
/// that decides it: the page shows it, and POST /job/run answers it.
/// @param sender_kind the sender that controls the machine, see Reception::sender_kind()
[[nodiscard]] std::string awaited_by_run(const ServedJob& job,
                                         std::string_view sender_kind,
                                         const cnc::Machine& machine);

/// The same for a job that was interrupted and is to be resumed; a machine in alarm is unlocked
/// where its position is known.
[[nodiscard]] std::string awaited_by_resume(const ServedJob& job,
                                            std::string_view sender_kind,
                                            const cnc::Machine& machine);

}  // namespace sim
