#pragma once

#include <Eigen/Core>
#include <vector>

#include "host-sim/surface/patch/piece_net.hpp"

namespace sim::surface::patch {

/// A chain of chords in a slicing plane.
struct SlicePath {
  /// Ends of the chords. In a closed path, the first point is not repeated at the end.
  std::vector<Eigen::Vector3d> points;
  bool is_closed = false;
  /// Upper bound, mm, of the distance between the chords and the exact curve in which the plane
  /// cuts the surface.
  double error_bound_mm = 0.0;
};

/// Returns the paths in which parallel planes, `normal` · x = distance, cut a surface of flat
/// pieces (paper 4, 4.2). A path is a chain of chords between the points at which the plane cuts
/// edges. Each point is computed once, by the closed formula, for both pieces at the edge. A path
/// thus has no gaps: it ends at the surface's rim or is closed.
///
/// The plane may cut the border of a piece at more than two points, a case that the paper excludes.
/// The chords of this piece then cut off the parts of its border that are on the opposite side of
/// the plane from its middle. A curve within one piece, for example at the top of a dome, is left
/// out. The surface exceeds the plane there by no more than the piece's flatness.
/// @param normal normal of the planes, of length 1
[[nodiscard]] std::vector<std::vector<SlicePath>> plane_slices(
    const PieceNet& net, const Eigen::Vector3d& normal, const std::vector<double>& distances_mm);

}  // namespace sim::surface::patch
