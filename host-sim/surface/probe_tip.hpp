#pragma once

#include <Eigen/Core>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"

namespace sim::surface {

/// Returns the points at which a ball touched a surface, computed from the ball's lowest points
/// over a grid. Each point is the ball's centre minus the radius times the surface's normal. The
/// normal comes from central differences of the neighbours' heights. At a border or next to a point
/// that was not measured, it comes from one-sided differences over three points.
///
/// No part of the surface is inside a ball that rests on the surface. So a computed point is never
/// below the surface, even if its normal is wrong. If the normal is off by an angle δ on a slope of
/// θ, the point is above the surface by at most r · (1 − cos δ) · (1 + r / R) / cos θ, to the
/// second order of δ. R is the surface's radius of curvature where it is convex, else infinite. For
/// a smooth surface δ is at most pitch² · |T‴| / 6 in each direction, and at most pitch² · |T‴| / 3
/// at borders, with the third derivative T‴ of the tip's height.
///
/// At ridges that are sharper than the ball, touched points coincide, or the error of the normals
/// changes their order. Where a quadrilateral would flip or lose its area, its points stay nearer
/// to the ball's lowest points. The result there is a point of the ball above the surface.
/// @param tips lowest points of the ball, row by row with rising X. If a point was not measured,
/// its Z is NaN and remains NaN
/// @param tip_mm diameter of the ball, ≥ 0
[[nodiscard]] std::vector<Eigen::Vector3d> touched_points(const ProbeGrid& grid,
                                                          const std::vector<Eigen::Vector3d>& tips,
                                                          double tip_mm);

}  // namespace sim::surface
