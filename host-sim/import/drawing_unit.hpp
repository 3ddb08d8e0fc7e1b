#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host-sim/import/outline_box.hpp"
#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// `mm, cm, m, um, inch, foot, mil, 96dpi, 90dpi, 72dpi`, for messages and help.
[[nodiscard]] std::string drawing_unit_names();

/// Returns millimetres per unit of one of these names; nothing for any other.
[[nodiscard]] std::optional<double> drawing_unit_mm(std::string_view name);

/// Notes that a drawing is larger or smaller than what lasers cut, which may be a slip of units,
/// with the unit that is likely. @param box around all that is drawn, mm
/// @param mm_per_unit by which it was read
void question_scale(Sketch& sketch, const OutlineBox& box, double mm_per_unit);

}  // namespace sim::drawing
