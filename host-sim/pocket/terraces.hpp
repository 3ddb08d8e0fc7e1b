#pragma once

#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// Areas that are milled from one depth to the next.
struct Terrace {
  /// Depth of the floor of the terrace above, below the top of the stock; or 0.
  double from_mm = 0.0;
  double to_mm = 0.0;  ///< Depth of the floor, greater than `from_mm`.
  Contour contours;    ///< Closed, with the areas on their left.
};

/// Terraces of an outermost contour and of all contours in it, from the top down.
using Terraces = std::vector<Terrace>;

/// Returns the terraces for contours that have floors at depths of their own. A deeper contour
/// within another is a pocket in a pocket; a less deep contour is a boss. Contours without a depth
/// follow the usual rule: within an even number of other contours they are pockets of the usual
/// depth, and the rest are islands as high as the stock.
/// @param contours closed, which do not cross
/// @param depths_mm depth of the floor within each loop, at least 0; none where the usual rule
/// holds
/// @param usual_mm above 0
[[nodiscard]] std::vector<Terraces> terraces_of(const Contour& contours,
                                                const std::vector<std::optional<double>>& depths_mm,
                                                double usual_mm);

}  // namespace sim::pocket
