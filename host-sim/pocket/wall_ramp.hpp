#pragma once

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "planner/pocket/loop_driver.hpp"

namespace sim::pocket {

/// Options for driving along a wall.
struct WallDrive {
  double depth_mm = 1.0;  ///< Depth of the floor below the top of the stock, mm.
  /// Steepest slope of a ramp: descent divided by length, above 0, at most 1.
  double slope = 0.05;
  bool plunges = false;  ///< Whether the tool plunges straight down instead of using a ramp.
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
};

/// Returns the number of times that the tool drives a ramp of length `length_mm`, forth, back or
/// around, until it reaches the depth. Throws NoPocketPath if that number exceeds 1000.
[[nodiscard]] double legs_of_ramp(const WallDrive& drive,
                                  double length_mm,
                                  const cnc::WideVec2& place);

/// Appends a row along a loop: down by a ramp around the loop, then once around the loop on the
/// floor. Throws the exception of legs_of_ramp().
void ramp_along_wall(const cnc::contour::ContourView<double>& locus,
                     std::size_t loop,
                     const WallDrive& drive,
                     PathRows& out);

/// Appends one revolution around a loop from `place`, without the end point.
void revolve(const cnc::contour::ContourView<double>& locus,
             const cnc::pocket::LoopPlace<double>& place,
             cnc::pocket::Milling milling,
             const cnc::pocket::LoopDrive<double>& drive,
             PathRows& out);

}  // namespace sim::pocket
