#pragma once

#include <Eigen/Core>

#include "host-sim/surface/patch/bezier_patch.hpp"
#include "host-sim/surface/patch/cubic.hpp"

namespace sim::surface::patch {

/// Methods that bound the distances of a patch from a plane through the origin, from the loosest to
/// the tightest.
enum class FlatnessTest {
  kControlHull,  ///< Bounds are the extremes of the 16 control points.
  /// Fat plane of paper 4, 4.1: computes the exact extremes of each row along v. They are the
  /// coefficients of two curves along u, whose extremes are the bounds.
  kFatPlane,
  /// Fat plane in both orders of the parameters, u after v and v after u. Each bound is the tighter
  /// of the two bounds.
  kBothOrders,
};

/// The space between two parallel planes that contain a patch between them (paper 4, figure 6); mm.
struct FatPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< Unit normal of the planes.
  Range distances;  ///< Distances of the two planes from the origin, along the normal.

  [[nodiscard]] double flatness() const { return distances.width(); }
};

/// Returns the unit normal of the patch's diagonals, (V33 − V00) × (V30 − V03). If the diagonals
/// are parallel or 0, returns the unit normal of the derivatives in the middle of the patch. If the
/// derivatives are parallel or 0, too, returns +Z.
[[nodiscard]] Eigen::Vector3d normal_of(const BezierPatch& patch);

/// Returns a fat plane that contains the complete patch.
[[nodiscard]] FatPlane fat_plane(const BezierPatch& patch, FlatnessTest test);

}  // namespace sim::surface::patch
