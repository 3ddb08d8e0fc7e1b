#pragma once

#include <Eigen/Core>
#include <vector>

#include "host-sim/surface/patch/piece_net.hpp"

namespace sim::surface::patch {

/// A chain of chords in a slicing plane.
struct SlicePath {
  /// Ends of the chords; in a closed path the first one is not repeated at the end.
  std::vector<Eigen::Vector3d> points;
  bool is_closed = false;
  /// Bound of the distance in the slicing plane between the chords and the curve in which the plane
  /// cuts the surface, mm.
  double error_bound_mm = 0.0;
};

/// Returns the paths in which each of the parallel planes `normal` · x = distance cuts a surface of
/// flat pieces (paper 4, 4.2). A path is a chain of chords between the points at which the plane
/// cuts the edges. Each such point is computed once, by the closed formula, for both pieces at the
/// edge. A path thus has no gaps: it ends at the surface's rim or is closed.
///
/// The plane may cut the border of a piece at more than two points, which the paper excludes. The
/// chords of such a piece cut off those parts of its border that are not on the side of its middle.
/// A curve that lies within one piece, such as at the top of a dome, is left out: it is no higher
/// than the piece's flatness.
/// @param normal normal of the planes, of length 1
[[nodiscard]] std::vector<std::vector<SlicePath>> plane_slices(
    const PieceNet& net, const Eigen::Vector3d& normal, const std::vector<double>& distances_mm);

}  // namespace sim::surface::patch
