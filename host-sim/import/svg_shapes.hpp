#pragma once

#include <string>
#include <string_view>

#include "host-sim/import/svg_attributes.hpp"
#include "host-sim/import/svg_cascade.hpp"
#include "host-sim/import/svg_path.hpp"

namespace sim::drawing {

/// Returns whether a name is path, rect, circle, ellipse, line, polyline or polygon.
[[nodiscard]] bool is_svg_shape(std::string_view name);

/// The fault of a shape; `reason` is empty if the shape has no fault.
struct SvgShapeFault {
  std::string reason{};
  bool is_error = true;  ///< True for an error; false for a note that the shape draws nothing.
};

/// Draws a basic shape in the units of its element.
/// @pre is_svg_shape(name)
[[nodiscard]] SvgShapeFault draw_svg_shape(std::string_view name,
                                           const SvgProperties& properties,
                                           const SvgViewport& viewport,
                                           SvgPen& pen);

/// Returns the point that the attributes `x` and `y` of an element give; a missing attribute counts
/// as 0.
[[nodiscard]] Place svg_place(const SvgProperties& properties, const SvgViewport& viewport);

}  // namespace sim::drawing
