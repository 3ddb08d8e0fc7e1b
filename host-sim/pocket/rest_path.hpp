#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/pocket/wall_ramp.hpp"

namespace sim::pocket {

/// Stock thinner than this, mm, counts as taken by the former tool.
inline constexpr double kThinRestMm = 0.5e-3;

/// How the rest is milled that a larger tool has left.
struct RestOptions {
  double tool_radius_mm = 1.5;
  double former_radius_mm = 3.0;  ///< Of the tool that went before, larger.
  WallDrive drive;                ///< Along the passes.
};

/// Passes where a larger tool has left stock, at one depth.
struct RestPath : PathRows {
  std::uint32_t pieces = 0;  ///< Of passes, each a row.
};

/// Returns the parts of passes at which the tool meets stock that the former tool has left, but for
/// what is thinner than kThinRestMm. Each part begins and ends in cleared stock, a little before
/// and after, on an arc that touches it; where no arc fits, a ramp forth and back along the part
/// leads down to it. Parts are grouped by where they are, and in each group the ones farther from
/// the wall come first.
/// Throws NoPocketPath where a part is too short for a ramp, and NoOffset.
/// @param pocket closed contours with the pocket on their left, into which both tools fit
/// @param passes that clear the pocket with the tool, each after the one around it
[[nodiscard]] RestPath rest_path(const cnc::contour::ContourView<double>& pocket,
                                 const std::vector<Contour>& passes,
                                 const RestOptions& options);

}  // namespace sim::pocket
