#pragma once

#include <string>

#include "host-sim/import/drawing.hpp"

namespace sim {

/// What was read of a drawing, as an SVG document: the material that is left (outer
/// contours filled, holes not), open contours dashed, a ring at each fault that has
/// a place. A drawing without contours is a valid picture of nothing.
[[nodiscard]] std::string draw_contours(const drawing::Drawing& drawn);

}  // namespace sim
