#pragma once

#include <vector>

#include "host-sim/pocket/stock_parts.hpp"

namespace sim::pocket {

/// Stock thinner than this, mm, counts as taken by the former tool.
inline constexpr double kThinRestMm = 0.5e-3;

/// How the rest is milled that a larger tool has left.
struct RestOptions {
  double tool_radius_mm = 1.5;
  double former_radius_mm = 3.0;  ///< Of the tool that went before, larger.
  WallDrive drive;                ///< Along the passes.
};

/// Returns the parts of passes at which the tool meets stock that the former tool has left, but for
/// what is thinner than kThinRestMm. Throws as parts_in_stock() does, and NoOffset.
/// @param pocket closed contours with the pocket on their left, into which both tools fit
/// @param passes that clear the pocket with the tool, each after the one around it
[[nodiscard]] StockParts rest_path(const cnc::contour::ContourView<double>& pocket,
                                   const std::vector<Contour>& passes,
                                   const RestOptions& options);

}  // namespace sim::pocket
