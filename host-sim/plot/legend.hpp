#pragma once

#include <string>

#include "host-sim/plot/legend_content.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// Smallest height of a box that holds every entry.
inline constexpr double kLegendHeightPx = 660.0;

/// Appends colour scale, line samples, marks and scale bar, from the top of the box down.
void add_legend(std::string& out, const Box& box, const View& view, const LegendContent& content);

/// Append the marks where the path starts (ring) and ends (square). Both stay visible at the same
/// point.
void add_start_mark(std::string& out, double x_px, double y_px);
void add_end_mark(std::string& out, double x_px, double y_px);

}  // namespace sim
