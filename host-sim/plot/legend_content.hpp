#pragma once

#include <vector>

#include "host-sim/plot/path.hpp"

namespace sim {

/// What the picture shows and the legend explains.
struct LegendContent {
  Shown shown = Shown::kSpeed;
  /// The end of the colour scale, in mm/min; of depth in mm, of power in percent. 0: no scale.
  double top_speed_mm_min = 0.0;
  double tick_speed_mm_min = 0.0;  ///< Divides the scale.
  double kerf_width_mm = 0.0;
  bool has_cut = false;
  bool has_feed = false;
  bool has_travel = false;
  bool has_marks = true;  ///< Of start and end.
};

/// Finds a round scale for the speeds, and the kinds of move that can be seen:
/// a few steps with the beam off at a corner are no entry of their own.
[[nodiscard]] LegendContent legend_content(const std::vector<PathVertex>& vertices,
                                           double kerf_width_mm,
                                           double px_per_mm,
                                           Shown shown = Shown::kSpeed);

/// The unit of a legend's scale in that of the path's vertices: mm/s, mm, or shares.
[[nodiscard]] double legend_unit(Shown shown);

}  // namespace sim
