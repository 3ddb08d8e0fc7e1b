#include "planner/gcode/execution.hpp"

namespace cnc::gcode {

Refusal Execution::run_jog() {
  if (const auto fault = check_jog_words()) return fault;
  set_modes();
  next_.modal.motion = MotionMode::kLine;
  next_.modal.feed_mode = FeedMode::kUnitsPerMinute;
  next_.modal.feed = 0.0F;  // Each jog must give its own feed, so the present feed is cleared.
  if (const auto fault = check_signs()) return fault;
  if (const auto fault = number_line()) return fault;
  if (const auto fault = set_feed()) return fault;
  if (!block_.has_axis_word()) {
    Fault fault{.detail = FaultDetail::kAxisWordsMissing};
    fault.letter = 'J';
    return fault;
  }
  if (const auto fault = check_feed()) return fault;
  if (const auto fault = move_straight()) return fault;
  return block_.unused_word();
}

std::uint32_t Execution::commit_jog() {
  context_.position = next_.position;
  return next_.modal.line_number;
}

/// Refuses all G and M words except those of units, distance and G53. Other letters that a jog does
/// not use are refused later, as unused words.
Refusal Execution::check_jog_words() const {
  for (std::size_t index = 0; index < kModalGroupCount; ++index) {
    const auto group = static_cast<ModalGroup>(index);
    if (!block_.has(group) || group == ModalGroup::kUnits || group == ModalGroup::kDistance)
      continue;
    const bool g53 =
        group == ModalGroup::kNonModal && block_.non_modal() == NonModal::kMachineCoordinates;
    if (!g53) return block_.blame(FaultDetail::kNotInAJog, group);
    if (context_.modal.tool_centre) return block_.blame(FaultDetail::kNotAtToolCentre, group);
  }
  return std::nullopt;
}

}  // namespace cnc::gcode
