#pragma once

#include <vector>

#include "host-sim/pocket/stock_parts.hpp"

namespace sim::pocket {

/// Stock thinner than this, mm, counts as removed by the former tool.
inline constexpr double kThinRestMm = 0.5e-3;

/// Returns the parts of passes at which the tool touches stock that the former tool has left.
/// Ignores stock thinner than kThinRestMm. Throws the exceptions of parts_in_stock(), and NoOffset.
/// @param pocket closed contours with the pocket on their left, into which both tools fit
/// @param former_radius_mm radius of the former tool, greater than that of the tool
/// @param passes passes that clear the pocket with the tool, each after the pass around it
[[nodiscard]] StockParts rest_path(const cnc::contour::ContourView<double>& pocket,
                                   double former_radius_mm,
                                   const std::vector<Contour>& passes,
                                   const PartOptions& options);

}  // namespace sim::pocket
