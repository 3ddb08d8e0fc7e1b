#include "host-sim/machine/simulator.hpp"

namespace sim {
namespace {

constexpr unsigned kTurnsPerProgress = 256;
/// So often does the sender show that it is there.
constexpr unsigned kTurnsPerStatus = 100;

}  // namespace

Simulator::Simulator(std::string program, RunOptions options)
    : options_{std::move(options)},
      link_{std::move(program), options_.after_refusal},
      controller_{link_, options_.machine} {}

std::string Simulator::change_setting(std::uint16_t number, float value) {
  const auto stored = machine().change_setting(number, value);
  return stored.ok() ? std::string{} : std::string{cnc::describe(stored.error())};
}

RunResult Simulator::run() {
  unsigned turns = 0;
  while (!done()) {
    turn();
    attend_pause();
    if (options_.on_progress && ++turns % kTurnsPerProgress == 0) {
      options_.on_progress(link_.progress());
    }
  }
  controller_.end();
  return result();
}

void Simulator::turn() {
  if (++turns_to_status_ == kTurnsPerStatus) {
    turns_to_status_ = 0;
    link_.ask_status();
  }
  controller_.turn();
  // There is nobody to home the machine, and where it stands is its zero.
  if (machine().alarm() == cnc::Alarm::kHomingRequired) machine().unlock();
  if (!controller_.step_timer_runs() && done()) controller_.take_back_idle_time();
}

bool Simulator::done() const {
  const cnc::Machine& machine = controller_.machine();
  if (machine.alarm() != cnc::Alarm::kNone) return !controller_.step_timer_runs();
  return link_.finished() && machine.idle();
}

/// An operator who presses cycle start at once.
void Simulator::attend_pause() {
  switch (machine().state()) {
    case cnc::MachineState::kHold:
      if (machine().status().substate != 0) return;
      notes_.emplace_back(link_.line(), "the program pauses here (M0); resumed at once");
      return machine().resume();
    case cnc::MachineState::kTool:
      if (tool_changed_) return;
      tool_changed_ = true;
      notes_.emplace_back(link_.line(), "the program asks for another tool (M6); resumed at once");
      return machine().resume();
    default:
      tool_changed_ = false;
  }
}

RunResult Simulator::result() const {
  const cnc::Machine& machine = controller_.machine();
  return {.job_time_s = static_cast<double>(now_ticks()) / cnc::motion::kTicksPerSecond,
          .lines = link_.line(),
          .blocks = machine.motion().blocks_taken(),
          .refusals = link_.refusals(),
          .notes = notes_,
          .alarm = static_cast<int>(machine.alarm()),
          .final_position = port().position};
}

}  // namespace sim
