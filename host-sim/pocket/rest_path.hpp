#pragma once

#include <vector>

#include "host-sim/pocket/stock_parts.hpp"

namespace sim::pocket {

/// Thickness below which stock counts as removed by the former tool, mm.
inline constexpr double kThinRestMm = 0.5e-3;

/// Returns the parts of passes on which the tool touches stock that the former tool has left.
/// Ignores stock thinner than kThinRestMm. Throws the exceptions of parts_in_stock(), and NoOffset.
/// @param pocket closed contours with the pocket on their left; both tools must fit into it
/// @param former_radius_mm radius of the former tool, greater than that of the tool in use
/// @param passes passes that clear the pocket with the tool in use; each follows the pass around it
[[nodiscard]] StockParts rest_path(const cnc::contour::ContourView<double>& pocket,
                                   double former_radius_mm,
                                   const std::vector<Contour>& passes,
                                   const PartOptions& options);

}  // namespace sim::pocket
