#include "planner/base/units.hpp"
#include "planner/gcode/execution.hpp"

namespace cnc::gcode {

/// Handles path control. P and Q are lengths in the units of the line, and are read for G64 only.
/// Each G64 sets or clears both tolerances.
Refusal Execution::set_path_control() {
  if (!block_.has(ModalGroup::kPathControl)) return std::nullopt;
  PathControl path{.mode = block_.meaning<PathMode>(ModalGroup::kPathControl)};
  if (path.mode == PathMode::kBlend) {
    if (const auto fault = take_tolerance('P', path.tolerance_mm)) return fault;
    if (const auto fault = take_tolerance('Q', path.naive_tolerance_mm)) return fault;
  }
  next_.modal.path = path;
  return std::nullopt;
}

Refusal Execution::take_tolerance(char letter, std::optional<float>& tolerance_mm) {
  const Decimal* const number = block_.take(letter);
  if (number == nullptr) return std::nullopt;
  if (number->is_negative()) return block_.blame(FaultDetail::kNegative, letter);
  const float length = to_length(*number).mm();
  if (length > options_.largest_path_tolerance_mm) {
    const bool inches = next_.modal.units == Units::kInches;
    const float unit = inches ? kMillimetresPerInch : 1.0F;
    Fault fault = block_.blame(FaultDetail::kTooLarge, letter);
    fault.limit = options_.largest_path_tolerance_mm / unit;
    return fault;
  }
  tolerance_mm = length;
  return std::nullopt;
}

}  // namespace cnc::gcode
