#pragma once

#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// Areas that are milled from one depth to the next one.
struct Terrace {
  double from_mm = 0.0;  ///< Below the top of the stock: the floor of the terrace above, or 0.
  double to_mm = 0.0;    ///< Deeper.
  Contour contours;      ///< Closed, with the areas on their left.
};

/// The terraces of an outermost contour and of all contours in it, from the top down.
using Terraces = std::vector<Terrace>;

/// Returns how contours are milled within which the floor lies at depths of their own: a deeper one
/// in another is a pocket in a pocket, a less deep one a boss. Where no depth is given, contours
/// within an even number of others are pockets of the usual depth, and the rest are islands as high
/// as the stock.
/// @param contours closed, which do not cross
/// @param depths_mm of the floor within each loop, at least 0; none where the usual rule holds
/// @param usual_mm above 0
[[nodiscard]] std::vector<Terraces> terraces_of(const Contour& contours,
                                                const std::vector<std::optional<double>>& depths_mm,
                                                double usual_mm);

}  // namespace sim::pocket
