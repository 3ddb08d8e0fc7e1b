#include "host-sim/serve/run_conditions.hpp"

#include <fmt/format.h>

#include "firmware/protocol/report_lines.hpp"
#include "host-sim/serve/reception.hpp"

namespace sim {
namespace {

/// Returns the condition for which both a start and a resumption of the job have to wait.
std::string awaited_by_both(const ServedJob& job, std::string_view sender_kind) {
  if (!job.loaded()) return "a program: open one";
  if (job.running()) return "the end of the running job";
  if (!job.program()->barriers.empty()) {
    return "a program that can be sent; " + job.program()->barriers.front();
  }
  if (sender_kind.empty()) return "control: take control";
  if (sender_kind != Reception::kPage) return "control, which another sender has";
  return {};
}

}  // namespace

std::string awaited_by_run(const ServedJob& job,
                           std::string_view sender_kind,
                           const cnc::Machine& machine) {
  if (std::string reason = awaited_by_both(job, sender_kind); !reason.empty()) return reason;
  const ServedProgram& program = *job.program();
  if (program.has_slashes && program.block_delete != machine.interpreter().options().block_delete) {
    return "the program to be opened again: block delete ($890, $B) was switched after it was "
           "opened";
  }
  const cnc::MachineState state = machine.state();
  if (state == cnc::MachineState::kAlarm) return "the end of the alarm: home or unlock";
  if (state == cnc::MachineState::kIdle) return {};
  return fmt::format("an idle machine; it is in {}", cnc::name_of(state));
}

std::string awaited_by_resume(const ServedJob& job,
                              std::string_view sender_kind,
                              const cnc::Machine& machine) {
  if (job.state() != ServedJob::State::kStopped) return "a job that was interrupted";
  std::string reason = awaited_by_both(job, sender_kind);
  if (!reason.empty() || machine.state() == cnc::MachineState::kAlarm) return reason;
  return awaited_by_run(job, sender_kind, machine);
}

}  // namespace sim
