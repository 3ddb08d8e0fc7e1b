#pragma once

#include <Eigen/Core>
#include <vector>

#include "host-sim/surface/patch/piece_net.hpp"

namespace sim::surface::patch {

/// A chain of chords in a slicing plane.
struct SlicePath {
  std::vector<Eigen::Vector3d> points;  ///< The first is not repeated at the end of a closed path.
  bool is_closed = false;
  /// Bound of the distance, within the slicing plane, of the chords from the curve in which the
  /// plane cuts the surface; mm.
  double error_bound_mm = 0.0;
};

/// Returns the paths in which each of the parallel planes `normal` · x = distance cuts a surface of
/// flat pieces (paper 4, 4.2): chords between the points at which the plane cuts the edges, each
/// computed once for both pieces at the edge by the closed formula. A path thus has no gaps; it
/// ends at the surface's rim or is closed.
///
/// A piece whose border the plane cuts at more than two points (the paper assumes that there is
/// none) gets chords that cut off the parts of the border on the other side than its middle. A
/// curve that lies within one piece, as at the top of a dome, is left out: it is no higher than the
/// piece's flatness.
/// @param normal of length 1
[[nodiscard]] std::vector<std::vector<SlicePath>> plane_slices(
    const PieceNet& net, const Eigen::Vector3d& normal, const std::vector<double>& distances_mm);

}  // namespace sim::surface::patch
