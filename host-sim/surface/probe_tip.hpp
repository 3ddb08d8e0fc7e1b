#pragma once

#include <Eigen/Core>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"

namespace sim::surface {

/// Returns the points at which a ball touched, from those of its lowest point over a grid: centre
/// less radius times normal, with the normal by central differences of the neighbours' heights
/// (of three points at a border, or beside one that was not measured).
///
/// The surface is nowhere inside a ball that has come down on it, so a point on the ball's lower
/// half is never below the surface, whichever normal leads to it. Where the normal is off by δ on a
/// slope of θ it is above by r · (1 − cos δ) · (1 + r / R) / cos θ at most, to the second order of
/// δ; R is the radius of the surface where that is a dome, else infinite. For a smooth surface δ is
/// pitch² · |T‴| / 6 at most in each direction, and pitch² · |T‴| / 3 at borders, with the third
/// derivative T‴ of the tip's height.
///
/// Round ridges that are sharper than the ball, points of touch come together, or change places by
/// the error of normals. Where a quadrilateral would turn over or have no area left, its points
/// stay nearer below the centres of their balls, and the surface is that of the ball there.
/// @param tips row by row with X rising; Z is NaN where none was measured, and stays so
/// @param tip_mm diameter of the ball, ≥ 0
[[nodiscard]] std::vector<Eigen::Vector3d> touched_points(const ProbeGrid& grid,
                                                          const std::vector<Eigen::Vector3d>& tips,
                                                          double tip_mm);

}  // namespace sim::surface
