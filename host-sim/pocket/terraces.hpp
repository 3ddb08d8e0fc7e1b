#pragma once

#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// Areas that are milled from one depth to the next.
struct Terrace {
  /// Depth of the floor of the terrace above, measured from the top of the stock, mm; 0 for the top
  /// terrace.
  double from_mm = 0.0;
  double to_mm = 0.0;  ///< Depth of the terrace's own floor, mm; greater than `from_mm`.
  Contour contours;    ///< Closed contours with the areas on their left.
};

/// Terraces of an outermost contour and of all contours in it, from the top down.
using Terraces = std::vector<Terrace>;

/// Returns the terraces for contours that have floors at individual depths. A deeper contour within
/// another contour is a pocket in a pocket. A less deep contour within another contour is a boss.
/// Contours without a depth follow the usual rule: those within an even number of other contours
/// are pockets of the depth `usual_mm`; the rest are islands as high as the stock.
/// @param contours closed contours that do not cross
/// @param depths_mm for each loop, the depth of the floor within it, at least 0; none where the
/// usual rule applies
/// @param usual_mm above 0
[[nodiscard]] std::vector<Terraces> terraces_of(const Contour& contours,
                                                const std::vector<std::optional<double>>& depths_mm,
                                                double usual_mm);

}  // namespace sim::pocket
