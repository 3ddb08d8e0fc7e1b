#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns places of a tip on a ramp into the stock, above the first part of a run, there and back
/// as often as it takes, from `top_mm` at its start down to just above its start. Lines between
/// them are nowhere below the run. Empty where the run is too short for a ramp, or begins above the
/// top.
/// @param run stretches without a lift between them, at least one
/// @param slope mm per mm in the plan, above 0
[[nodiscard]] std::vector<Eigen::Vector3d> ramp_entry(std::span<const SurfaceStretch> run,
                                                      double top_mm,
                                                      double slope);

}  // namespace sim::surface
