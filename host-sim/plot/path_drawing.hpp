#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/plot/path.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// Line weights, which the samples in the legend share.
inline constexpr double kCutWidthPx = 2.6;
inline constexpr double kFeedWidthPx = 1.6;
inline constexpr double kTravelWidthPx = 1.5;
inline constexpr double kTravelDashPx = 7.0;
inline constexpr double kTravelGapPx = 6.0;
inline constexpr std::string_view kTravelStroke = "#8a8f98";
inline constexpr std::string_view kKerfStroke = "#d6d2cb";

struct PathDrawing {
  double kerf_width_mm = 0.0;   ///< Width of the kerf below the cut, true to scale; 0 draws none.
  double top_speed_mm_s = 0.0;  ///< End of the colour scale, in the unit of `shown`.
  Shown shown = Shown::kSpeed;
};

/// Returns the colour for a share of the scale: light for fast, dark for deep and for powerful.
[[nodiscard]] std::string colour_of(Shown shown, double share);

/// Appends the path: the kerf lowest, then travel, feed, and cut from light to dark, so that a
/// short slow corner and the last depth are not hidden. Each colour is one <path>, which keeps the
/// file small in any order of speeds.
void add_path(std::string& out,
              const std::vector<PathVertex>& vertices,
              const View& view,
              const PathDrawing& drawing);

}  // namespace sim
