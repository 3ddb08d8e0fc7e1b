#pragma once

#include <vector>

#include "host-sim/pocket/stock_parts.hpp"

namespace sim::pocket {

/// Stock thinner than this, mm, counts as taken by the former tool.
inline constexpr double kThinRestMm = 0.5e-3;

/// Returns the parts of passes at which the tool meets stock that the former tool has left, but for
/// what is thinner than kThinRestMm. Throws as parts_in_stock() does, and NoOffset.
/// @param pocket closed contours with the pocket on their left, into which both tools fit
/// @param former_radius_mm radius of the tool that went before, above that of the tool
/// @param passes that clear the pocket with the tool, each after the one around it
[[nodiscard]] StockParts rest_path(const cnc::contour::ContourView<double>& pocket,
                                   double former_radius_mm,
                                   const std::vector<Contour>& passes,
                                   const PartOptions& options);

}  // namespace sim::pocket
