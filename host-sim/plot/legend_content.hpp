#pragma once

#include <vector>

#include "host-sim/plot/path.hpp"

namespace sim {

/// Data of the picture that the legend explains.
struct LegendContent {
  Shown shown = Shown::kSpeed;
  /// The end of the colour scale: speed in mm/min, depth in mm, or power in percent. 0 stands for
  /// no scale.
  double top_speed_mm_min = 0.0;
  double tick_speed_mm_min = 0.0;  ///< Interval of the marks on the scale.
  double kerf_width_mm = 0.0;
  bool has_cut = false;
  bool has_feed = false;
  bool has_travel = false;
  bool has_marks = true;  ///< The legend has the marks of start and end.
};

/// Returns the content of a legend: a round scale for the speeds, and the kinds of move that can be
/// seen. A few steps with the beam off at a corner get no entry of their own.
[[nodiscard]] LegendContent legend_content(const std::vector<PathVertex>& vertices,
                                           double kerf_width_mm,
                                           double px_per_mm,
                                           Shown shown = Shown::kSpeed);

/// Returns the unit of a legend's scale in the unit of the path's vertices (mm/s, mm, or share).
[[nodiscard]] double legend_unit(Shown shown);

}  // namespace sim
