#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/plot/path.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// Line widths. The samples in the legend have the same widths.
inline constexpr double kCutWidthPx = 2.6;
inline constexpr double kFeedWidthPx = 1.6;
inline constexpr double kTravelWidthPx = 1.5;
inline constexpr double kTravelDashPx = 7.0;
inline constexpr double kTravelGapPx = 6.0;
inline constexpr std::string_view kTravelStroke = "#8a8f98";
inline constexpr std::string_view kKerfStroke = "#d6d2cb";

struct PathDrawing {
  /// Width of the kerf, which is drawn to scale below the cut. 0 for no kerf.
  double kerf_width_mm = 0.0;
  double top_speed_mm_s = 0.0;  ///< End of the colour scale, in the unit of `shown`.
  Shown shown = Shown::kSpeed;
};

/// Returns the colour for a share of the scale. High speeds are light. Great depths and high powers
/// are dark.
[[nodiscard]] std::string colour_of(Shown shown, double share);

/// Appends the path: first the kerf, then travel, feed, and the cuts from light to dark colours.
/// Later content covers earlier content, so a short slow corner and the last depth are not hidden.
/// Each colour is one <path>, which keeps the file small for any order of speeds.
void add_path(std::string& out,
              const std::vector<PathVertex>& vertices,
              const View& view,
              const PathDrawing& drawing);

}  // namespace sim
