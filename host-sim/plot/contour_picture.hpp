#pragma once

#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "planner/pocket/tool_path.hpp"

namespace sim {

/// Returns an SVG document of contours over a grid: the input in grey with its area filled, and
/// each of the offsets in a colour of its own. Arcs are drawn as arcs.
[[nodiscard]] std::string draw_contours(const Contour& input,
                                        const std::vector<Contour>& offsets,
                                        const std::string& title);

/// Returns an SVG document of a tool path over the walls of its pockets. Passes have colours by
/// depth, links are dashed, and entries are green. Rapids are not drawn.
[[nodiscard]] std::string draw_tool_path(const Contour& walls,
                                         const cnc::pocket::ToolPathView<double>& path,
                                         const std::string& title);

}  // namespace sim
