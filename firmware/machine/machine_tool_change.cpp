#include <utility>

#include "firmware/machine/machine.hpp"

/// A tool change in which the sender takes part.
namespace cnc {

using Stage = ToolChange::Stage;

bool Machine::acknowledge_tool() {
  if (!state_.in(Mode::kTool) || tool_change_.open() || restarting_) return false;
  check_settings();
  forget_exit();
  ToolChange::Job& job = tool_change_.job();
  job.interpreter = interpreter_;
  job.waiting = waiting_;
  job.with_next_motion = with_next_motion_;
  job.place = motion_.target();
  job.step_pause = step_pause_;
  waiting_ = {};
  with_next_motion_ = {};
  step_pause_ = false;
  interpreter_.begin_tool_change(motion_.target());
  settings_watch_.accept();
  tool_change_.go_to(Stage::kOpen);
  return true;
}

/// The program's own lines and modes again, with the offsets as they are now.
void Machine::close_tool_change() {
  check_settings();
  ToolChange::Job& job = tool_change_.job();
  interpreter_.end_tool_change(job.interpreter);
  settings_watch_.accept();
  trust_places();
  waiting_ = job.waiting;
  with_next_motion_ = job.with_next_motion;
  step_pause_ = job.step_pause;
  tool_change_.go_to(Stage::kClosed);
}

/// What stops a program ends here what moves: nothing of it goes on, and the change stays open.
void Machine::stop_in_tool_change() {
  line_failed_ = line_failed_ || !waiting_.empty() || jog_;
  if (tool_change_.returns()) {
    tool_.suspend(true);
    restart_dwell_.cancel();
  }
  motion_.halt();
  tool_change_.go_to(Stage::kStopping);
}

void Machine::drop_in_tool_change() {
  waiting_ = {};
  elements_.clear();
  jog_.reset();
  dwelling_ = false;
  dwell_.cancel();
  probing_ = Probing::kNo;
  drive_.disarm_probe();
  motion_.drop_rest();
  motion_.go_on();
  interpreter_.set_position(motion_.target());
  tool_change_.go_to(Stage::kOpen);
}

/// Dark, and without an override of the feed, as a jog.
void Machine::go_straight(const Position& end) {
  jog_ = JogMove{.end = end};
  append_jog();
}

void Machine::attend_tool_change() {
  if (inputs().door && !motion_.drained() && tool_change_.stage() != Stage::kStopping) {
    stop_in_tool_change();
  }
  const Position& back = tool_change_.job().place;
  const Position high = ToolChange::no_lower(back, motion_.target());
  switch (tool_change_.stage()) {
    case Stage::kClosed:
      return;
    case Stage::kStopping:
      if (at_rest()) drop_in_tool_change();
      return;
    case Stage::kEnding:
      if (waiting_.empty() && !jog_ && motion_.drained()) {
        go_straight(ToolChange::no_lower(motion_.target(), back));
        go_straight(high);
        return tool_change_.go_to(Stage::kAcross);
      }
      [[fallthrough]];
    case Stage::kOpen:
      if (jog_ && motion_.has_room()) append_jog();
      return;
    case Stage::kAcross:
      if (!motion_.drained()) return;
      give_tool_back();
      return tool_change_.go_to(Stage::kSpindle);
    case Stage::kSpindle:
      if (!restart_dwell_.over()) return;
      go_straight(back);
      return tool_change_.go_to(Stage::kDown);
    case Stage::kDown:
      if (!motion_.drained()) return;
      close_tool_change();
      return restart();
  }
}

bool Machine::take_line_failure() { return std::exchange(line_failed_, false); }

}  // namespace cnc
