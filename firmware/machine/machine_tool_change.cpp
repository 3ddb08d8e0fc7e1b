#include <algorithm>

#include "firmware/machine/machine.hpp"

/// A tool change in which the sender takes part.
namespace cnc {

using Stage = ToolChange::Stage;

bool Machine::acknowledge_tool() {
  if (!state_.in(Mode::kTool) || tool_change_.open() || resumption_.pending()) return false;
  memory_.check_settings();
  forget_exit();
  ToolChange::Job& job = tool_change_.job();
  job.interpreter = interpreter_;
  job.line = actions_.set_aside();
  job.place = motion_.target();
  interpreter_.begin_tool_change(motion_.target());
  memory_.trust_settings(true);
  tool_change_.go_to(Stage::kOpen);
  return true;
}

/// Restores the rest of the line of M6 and the modes of the program. Keeps the offsets that the
/// tool change has set.
void Machine::close_tool_change() {
  memory_.check_settings();
  ToolChange::Job& job = tool_change_.job();
  interpreter_.end_tool_change(*job.interpreter);
  memory_.trust_settings(true);
  trust_places();
  actions_.take_back(job.line);
  tool_change_.go_to(Stage::kClosed);
}

/// Stops the motion of the present line or jog in a tool change. The remaining motion is dropped,
/// and the tool change stays open.
void Machine::stop_in_tool_change() {
  if (!actions_.empty() || jog_) news_.line_failed.raise();
  motion_.halt();
  tool_change_.go_to(Stage::kStopping);
}

void Machine::drop_in_tool_change() {
  actions_.drop();
  jog_.reset();
  probing_.cancel();
  drive_.disarm_probe();
  motion_.drop_rest();
  motion_.go_on();
  interpreter_.set_position(motion_.target());
  tool_change_.go_to(Stage::kOpen);
}

void Machine::attend_tool_change() {
  const Stage stage = tool_change_.stage();
  const bool rests = actions_.empty() && !jog_ && motion_.drained();
  if (stage == Stage::kStopping) {
    if (motion_.at_rest()) drop_in_tool_change();
  } else if (inputs().door && !motion_.drained()) {
    stop_in_tool_change();
  } else if (jog_ && motion_.has_room()) {
    append_jog();
  } else if (stage == Stage::kEnding && rests) {
    go_back_to(tool_change_.job().place);
    tool_change_.go_to(Stage::kReturning);
  } else if (stage == Stage::kReturning && rests) {
    close_tool_change();
    resume();
  }
}

/// Moves back to `place` by rapids: up, then across, then down.
void Machine::go_back_to(const Position& place) {
  constexpr std::size_t kZ = index_of(Axis::kZ);
  Position way = motion_.target();
  const Coordinate height = std::max(way[kZ], place[kZ]);
  way[kZ] = height;
  drive_straight(way, 0.0F);
  way = place;
  way[kZ] = height;
  drive_straight(way, 0.0F);
  drive_straight(place, 0.0F);
}

}  // namespace cnc
