#pragma once

#include <string>
#include <string_view>

#include "host-sim/import/svg_attributes.hpp"
#include "host-sim/import/svg_cascade.hpp"
#include "host-sim/import/svg_path.hpp"

namespace sim::drawing {

/// path, rect, circle, ellipse, line, polyline, polygon.
[[nodiscard]] bool is_svg_shape(std::string_view name);

/// What is wrong with a shape. Empty: nothing.
struct SvgShapeFault {
  std::string reason{};
  bool is_error = true;  ///< Else it is drawn as nothing.
};

/// Draws one of them in the units of its element.
/// @pre is_svg_shape(name)
[[nodiscard]] SvgShapeFault draw_svg_shape(std::string_view name,
                                           const SvgProperties& properties,
                                           const SvgViewport& viewport,
                                           SvgPen& pen);

/// Returns `x` and `y` of an element, each 0 where it has none.
[[nodiscard]] Place svg_place(const SvgProperties& properties, const SvgViewport& viewport);

}  // namespace sim::drawing
