#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host-sim/import/outline_box.hpp"
#include "host-sim/import/sketch.hpp"

namespace sim::drawing {

/// Returns the list `mm, cm, m, um, inch, foot, mil, 96dpi, 90dpi, 72dpi`, for messages and help.
[[nodiscard]] std::string drawing_unit_names();

/// Returns the millimetres per unit of a name that drawing_unit_names() lists; nothing for any
/// other name.
[[nodiscard]] std::optional<double> drawing_unit_mm(std::string_view name);

/// Adds a note if a drawing is larger or smaller than the usual work of a laser, because its unit
/// may then be wrong. The note names the most likely unit.
/// @param box rectangle around the whole drawing, mm
/// @param mm_per_unit unit with which the drawing was read
void question_scale(Sketch& sketch, const OutlineBox& box, double mm_per_unit);

}  // namespace sim::drawing
