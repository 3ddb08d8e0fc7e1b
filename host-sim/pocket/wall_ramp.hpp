#pragma once

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "planner/pocket/loop_driver.hpp"

namespace sim::pocket {

/// How a tool goes along a wall.
struct WallDrive {
  double depth_mm = 1.0;  ///< Of the floor below the top.
  double slope = 0.05;    ///< Steepest descent over length of a ramp, 0…1 without 0.
  bool plunges = false;   ///< Straight down in place of a ramp.
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
};

/// Returns how often a ramp of a length is driven, forth or around, until it is so deep.
/// Throws NoPocketPath if that is more than a thousand times.
[[nodiscard]] double legs_of_ramp(const WallDrive& drive,
                                  double length_mm,
                                  const cnc::WideVec2& place);

/// Appends a row along a loop: down by a ramp around it, and once around on the floor.
/// Throws NoPocketPath as legs_of_ramp() does.
void ramp_along_wall(const cnc::contour::ContourView<double>& locus,
                     std::size_t loop,
                     const WallDrive& drive,
                     PathRows& out);

/// Appends one revolution of a loop from a place of it, without the point at its end.
void revolve(const cnc::contour::ContourView<double>& locus,
             const cnc::pocket::LoopPlace<double>& place,
             cnc::pocket::Milling milling,
             const cnc::pocket::LoopDrive<double>& drive,
             PathRows& out);

}  // namespace sim::pocket
