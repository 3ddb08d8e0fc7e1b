#include "host-sim/machine/simulator.hpp"

#include <algorithm>

namespace sim {
namespace {

constexpr unsigned kTurnsPerProgress = 256;
/// Greatest number of pauses that a result lists.
constexpr std::size_t kMaxPauses = 1000;
/// Number of cycles between two status requests, by which the sender shows that it is present.
constexpr unsigned kTurnsPerStatus = 100;
/// Number of cycles with the motors at rest after which the run ends, although motions are left.
/// Nothing would release these motions.
constexpr unsigned kTurnsOfWaiting = 100;
/// Number of cycles within which a line is answered after its motion raised an alarm.
constexpr unsigned kTurnsToAnswer = 100;

}  // namespace

Simulator::Simulator(std::string program, RunOptions options)
    : options_{std::move(options)},
      link_{std::move(program), options_.after_refusal},
      controller_{link_, options_.machine} {
  link_.on_taken = options_.on_taken;
  link_.on_answer = options_.on_answer;
  if (options_.skips_quiet_polls) controller_.skip_quiet_polls(link_);
  controller_.watch_memory(options_.watches_memory);
}

std::string Simulator::change_setting(std::uint16_t number, float value) {
  const auto stored = machine().change_setting(number, value);
  return stored.ok() ? std::string{} : std::string{cnc::describe(stored.error())};
}

RunResult Simulator::run() {
  unsigned turns = 0;
  while (!done()) {
    turn();
    if (in_alarm()) link_.stop();
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
  // The simulation has no operator who could home the machine. The position at the start therefore
  // counts as zero.
  if (machine().alarm() == cnc::Alarm::kHomingRequired) machine().unlock();
  count_turns();
  if (!controller_.step_timer_runs() && done()) controller_.take_back_idle_time();
}

/// Counts the cycles in which nothing moves although the program has not ended.
void Simulator::count_turns() {
  const bool waits = in_alarm() || (link_.finished() && machine().waits_for_g40());
  waiting_turns_ = waits && !controller_.step_timer_runs() ? waiting_turns_ + 1 : 0;
}

bool Simulator::in_alarm() const { return controller_.machine().alarm() != cnc::Alarm::kNone; }

/// Returns whether the run is over. After an alarm, the run continues until the answer to the line,
/// which contains the reason.
bool Simulator::done() const {
  const cnc::Machine& machine = controller_.machine();
  if (in_alarm()) {
    return !controller_.step_timer_runs() &&
           (!link_.awaits_answer() || waiting_turns_ > kTurnsToAnswer);
  }
  return link_.finished() && (machine.idle() || waiting_turns_ > kTurnsOfWaiting);
}

/// Acts as an operator who presses cycle start immediately.
void Simulator::attend_pause() {
  switch (machine().state()) {
    case cnc::MachineState::kHold:
      if (machine().status().substate != 0) return;
      note("the program pauses here (M0); the simulator resumes it immediately");
      return machine().resume();
    case cnc::MachineState::kTool:
      if (tool_changed_) return;
      tool_changed_ = true;
      note("the program requires another tool (M6); the simulator resumes it immediately");
      return machine().resume();
    default:
      tool_changed_ = false;
  }
}

void Simulator::note(std::string text) {
  if (notes_.size() > kMaxPauses) return;
  if (notes_.size() == kMaxPauses) text = "more pauses are not listed";
  notes_.emplace_back(link_.line(), std::move(text));
}

RunResult Simulator::result() const {
  const cnc::Machine& machine = controller_.machine();
  auto notes = notes_;
  const auto is_known = [this](std::size_t line) {
    return std::ranges::any_of(notes_, [line](const auto& note) { return note.first == line; });
  };
  // Skips the message of a tool change, because attend_pause() has already added a note about it.
  for (const auto& [line, message] : link_.messages()) {
    if (!is_known(line)) notes.emplace_back(line, message);
  }
  std::ranges::stable_sort(notes, {}, &std::pair<std::size_t, std::string>::first);
  if (machine.waits_for_g40()) {
    notes.emplace_back(link_.line(),
                       "the program ends with G41 or G42 on, so its last motions are not driven; "
                       "end it with G40 or M2");
  }
  return {.job_time_s = static_cast<double>(now_ticks()) / cnc::motion::kTicksPerSecond,
          .lines = link_.line(),
          .blocks = machine.motion().blocks_taken(),
          .refusals = link_.refusals(),
          .refused = link_.refused(),
          .notes = std::move(notes),
          .alarm = static_cast<int>(machine.alarm()),
          .final_position = port().position};
}

}  // namespace sim
