#include "firmware/machine/machine.hpp"

namespace cnc {

/// Returns an active ToolCentre with the present tool length if G43.4 is set; otherwise an inactive
/// one.
kinematics::ToolCentre Machine::wanted_tool_centre() const {
  if (!kinematics::kHasFiveAxes || !interpreter_.state().tool_centre) return {};
  return {rotary_machine_from(settings()), interpreter_.shift().tool_length};
}

/// Begins or ends G43.4. The axes do not move. The programmed position becomes the position of the
/// tip under G43.4, and the position of the axes after its end.
bool Machine::switch_tool_centre() {
  if (!standstill()) return false;
  tool_centre_ = wanted_tool_centre();
  motion_.set_tool_centre(tool_centre_);
  interpreter_.set_position(motion_.target());
  return true;
}

/// Ends G43.4, because single axes are to be moved.
/// @pre nothing moves
void Machine::end_tool_centre() {
  if (!tool_centre_.active()) return;
  interpreter_.end_tool_centre();
  static_cast<void>(switch_tool_centre());
}

/// Begins or ends G43.4 in check mode. Only the programmed position is converted, because nothing
/// moves.
void Machine::judge_tool_centre() {
  if (!kinematics::kHasFiveAxes) return;
  const Position axes = tool_centre_.axes_for(interpreter_.position());
  tool_centre_ = wanted_tool_centre();
  interpreter_.set_position(tool_centre_.program_for(axes));
}

/// Returns whether a motion of the actions would leave the travel.
/// @pre no action is being driven
bool Machine::leaves_travel(gcode::Actions actions, const Position& from) {
  if (!tool_centre_.active()) return travel_.left_by(actions, from);
  return travel_.left_by(actions, from, {tool_centre_, set_up_.limits()}, actions_.elements());
}

}  // namespace cnc
