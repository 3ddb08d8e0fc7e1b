#pragma once

#include <string>

#include "host-sim/plot/legend_content.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// Least height of a box that has enough space for all entries.
inline constexpr double kLegendHeightPx = 660.0;

/// Appends a legend: colour scale, line samples, marks and scale bar, from the top of the box
/// downwards.
void add_legend(std::string& out, const Box& box, const View& view, const LegendContent& content);

/// Append the marks of the start (a ring) and the end (a square) of the path. If start and end are
/// the same point, both marks are visible.
void add_start_mark(std::string& out, double x_px, double y_px);
void add_end_mark(std::string& out, double x_px, double y_px);

}  // namespace sim
