#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns positions of a tip on a ramp into the stock. The ramp goes back and forth above the
/// first part of a run. It begins over the run's start at the height `top_mm` and ends slightly
/// above the run's start. Lines between the positions are nowhere below the run. Returns an empty
/// vector if the run is too short for a ramp or begins above `top_mm`.
/// @param run stretches without a lift between them, at least one
/// @param slope slope of the ramp in plan, mm per mm, above 0
[[nodiscard]] std::vector<Eigen::Vector3d> ramp_entry(std::span<const SurfaceStretch> run,
                                                      double top_mm,
                                                      double slope);

}  // namespace sim::surface
