#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/plot/path.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// Line weights, shared with the samples in the legend.
inline constexpr double kCutWidthPx = 2.6;
inline constexpr double kFeedWidthPx = 1.6;
inline constexpr double kTravelWidthPx = 1.5;
inline constexpr double kTravelDashPx = 7.0;
inline constexpr double kTravelGapPx = 6.0;
inline constexpr std::string_view kTravelStroke = "#8a8f98";
inline constexpr std::string_view kKerfStroke = "#d6d2cb";

struct PathDrawing {
  double kerf_width_mm = 0.0;   ///< Drawn below the cut, true to scale; 0 draws none.
  double top_speed_mm_s = 0.0;  ///< The end of the colour scale, of whatever is shown.
  Shown shown = Shown::kSpeed;
};

/// The colour of a share of the scale: fast is light, deep and powerful are dark.
[[nodiscard]] std::string colour_of(Shown shown, double share);

/// Appends the path: kerf lowest, then travel, feed, and cut from light to dark,
/// so that a short slow corner and the last depth are not hidden. Each colour is one <path>, which
/// keeps the file small whatever the order of speeds.
void add_path(std::string& out,
              const std::vector<PathVertex>& vertices,
              const View& view,
              const PathDrawing& drawing);

}  // namespace sim
