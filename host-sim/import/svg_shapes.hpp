#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "host-sim/import/svg_attributes.hpp"
#include "host-sim/import/svg_path.hpp"

namespace sim::drawing {

/// path, rect, circle, ellipse, line, polyline, polygon.
[[nodiscard]] bool is_svg_shape(std::string_view name);

/// Draws one of them in the units of its element. Empty, or what is wrong.
/// @pre is_svg_shape(name)
[[nodiscard]] std::string draw_svg_shape(std::string_view name,
                                         const pugi::xml_node& node,
                                         const SvgViewport& viewport,
                                         SvgPen& pen);

}  // namespace sim::drawing
