#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns places of a tip on a ramp into the stock. The ramp is above the first part of a run and
/// goes back and forth as often as needed, from `top_mm` at the run's start down to just above the
/// run's start. Lines between the places are nowhere below the run. Returns an empty vector if the
/// run is too short for a ramp or begins above `top_mm`.
/// @param run stretches without a lift between them, at least one
/// @param slope slope of the ramp in plan, mm per mm, above 0
[[nodiscard]] std::vector<Eigen::Vector3d> ramp_entry(std::span<const SurfaceStretch> run,
                                                      double top_mm,
                                                      double slope);

}  // namespace sim::surface
