#pragma once

#include <Eigen/Core>

#include "host-sim/surface/patch/bezier_patch.hpp"
#include "host-sim/surface/patch/cubic.hpp"

namespace sim::surface::patch {

/// Bounds of a patch's distances from a plane through the origin, by rising tightness.
enum class FlatnessTest {
  kControlHull,  ///< Extremes of the 16 control points.
  kFatPlane,     ///< Paper 4, 4.1: exact extremes of the rows along v, and of their hull along u.
  kBothOrders,  ///< The fat plane with u after v and with v after u, of each bound the tighter one.
};

/// The space between two parallel planes that holds a patch (paper 4, figure 6); mm.
struct FatPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< A unit vector.
  Range distances;  ///< From the origin to the patch, along the normal.

  [[nodiscard]] double flatness() const { return distances.width(); }
};

/// Returns the unit normal of the diagonals, (V33 − V00) × (V30 − V03). Where these are parallel or
/// 0 it is that of the derivatives in the middle, and +Z where these do not help either.
[[nodiscard]] Eigen::Vector3d normal_of(const BezierPatch& patch);

/// Returns a fat plane that holds the whole patch.
[[nodiscard]] FatPlane fat_plane(const BezierPatch& patch, FlatnessTest test);

}  // namespace sim::surface::patch
