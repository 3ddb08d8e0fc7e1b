#pragma once

#include <string>

#include "host-sim/plot/view.hpp"

namespace sim {

/// What the picture shows and the legend explains.
struct LegendContent {
  double top_speed_mm_min = 0.0;   ///< The end of the colour scale; 0: no scale.
  double tick_speed_mm_min = 0.0;  ///< Divides the scale.
  double kerf_width_mm = 0.0;
  bool has_cut = false;
  bool has_feed = false;
  bool has_travel = false;
};

/// The least height of a box that holds every entry.
inline constexpr double kLegendHeightPx = 660.0;

/// Appends colour scale, line samples, marks and scale bar, from the top of the box down.
void add_legend(std::string& out, const Box& box, const View& view, const LegendContent& content);

/// Where the path starts (ring) and ends (square); both stay visible on one point.
void add_start_mark(std::string& out, double x_px, double y_px);
void add_end_mark(std::string& out, double x_px, double y_px);

}  // namespace sim
