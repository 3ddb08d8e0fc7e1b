#pragma once

#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "planner/pocket/tool_path.hpp"

namespace sim {

/// Returns an SVG document with contours over a grid. The area of the input is filled in grey, and
/// each offset has a different colour. Arcs are drawn as true arcs.
[[nodiscard]] std::string draw_contours(const Contour& input,
                                        const std::vector<Contour>& offsets,
                                        const std::string& title);

/// Returns an SVG document with a tool path over the walls of its pockets. The colour of a pass
/// depends on its depth. Links are dashed, and entries are green. Rapids are not drawn.
[[nodiscard]] std::string draw_tool_path(const Contour& walls,
                                         const cnc::pocket::ToolPathView<double>& path,
                                         const std::string& title);

}  // namespace sim
