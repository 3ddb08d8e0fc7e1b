#pragma once

#include <Eigen/Core>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"

namespace sim::surface {

/// Returns the points at which a ball touched a surface, computed from the ball's lowest points
/// over a grid. Each is the ball's centre minus radius times normal. The normal comes from central
/// differences of the neighbours' heights, or from three points at a border or next to a point that
/// was not measured.
///
/// No part of the surface lies inside a ball that rests on it, so that a point on the ball's lower
/// half is never below the surface, whichever normal leads to it. If the normal is off by an angle
/// δ on a slope of θ, the point is above the surface by at most r · (1 − cos δ) · (1 + r / R) / cos
/// θ, to the second order of δ. R is the radius of the surface where it is a dome, else infinite.
/// For a smooth surface δ is at most pitch² · |T‴| / 6 in each direction, and at most pitch² · |T‴|
/// / 3 at borders, with the third derivative T‴ of the tip's height.
///
/// At ridges that are sharper than the ball, points of touch coincide, or change their order by the
/// error of normals. Where a quadrilateral would flip or lose its area, its points stay nearer to
/// the points below the centres of their balls, and the surface is that of the ball there.
/// @param tips lowest points of the ball, row by row with X rising; Z is NaN if a point was not
/// measured, and stays NaN
/// @param tip_mm diameter of the ball, ≥ 0
[[nodiscard]] std::vector<Eigen::Vector3d> touched_points(const ProbeGrid& grid,
                                                          const std::vector<Eigen::Vector3d>& tips,
                                                          double tip_mm);

}  // namespace sim::surface
