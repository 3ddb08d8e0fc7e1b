#pragma once

#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "planner/pocket/tool_path.hpp"

namespace sim {

/// Contours as an SVG document: the input in grey, its area filled, and each of
/// the offsets in a colour of its own, over a grid. Arcs are drawn as arcs.
[[nodiscard]] std::string draw_contours(const Contour& input,
                                        const std::vector<Contour>& offsets,
                                        const std::string& title);

/// A tool path over the walls of its pockets as an SVG document: passes in colours by depth, links
/// dashed, entries in green. Rapids are not drawn.
[[nodiscard]] std::string draw_tool_path(const Contour& walls,
                                         const cnc::pocket::ToolPathView<double>& path,
                                         const std::string& title);

}  // namespace sim
