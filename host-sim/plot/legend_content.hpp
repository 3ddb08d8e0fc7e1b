#pragma once

#include <vector>

#include "host-sim/plot/path.hpp"

namespace sim {

/// The data from which a legend is drawn.
struct LegendContent {
  Shown shown = Shown::kSpeed;
  /// End of the colour scale: a speed in mm/min, a depth in mm, or a power in percent. 0 if there
  /// is no scale.
  double top_speed_mm_min = 0.0;
  double tick_speed_mm_min = 0.0;  ///< Interval between the marks on the scale, in the same unit.
  double kerf_width_mm = 0.0;
  bool has_cut = false;
  bool has_feed = false;
  bool has_travel = false;
  bool has_marks = true;  ///< True if the legend explains the marks of start and end.
};

/// Returns the content of a legend: a scale with round numbers, and the kinds of move that are
/// visible. A few steps with the beam off at a corner are not visible, so they cause no entry.
[[nodiscard]] LegendContent legend_content(const std::vector<PathVertex>& vertices,
                                           double kerf_width_mm,
                                           double px_per_mm,
                                           Shown shown = Shown::kSpeed);

/// Returns the unit of the scale of a legend (mm/min, mm or percent) in the unit of the vertices of
/// a path (mm/s, mm or share).
[[nodiscard]] double legend_unit(Shown shown);

}  // namespace sim
