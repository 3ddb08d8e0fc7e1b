#pragma once

#include <Eigen/Core>

#include "host-sim/surface/patch/bezier_patch.hpp"
#include "host-sim/surface/patch/cubic.hpp"

namespace sim::surface::patch {

/// Methods that bound a patch's distances from a plane through the origin, from the loosest to the
/// tightest.
enum class FlatnessTest {
  kControlHull,  ///< Extremes of the 16 control points.
  /// Paper 4, 4.1: exact extremes of the rows along v, and extremes of their hull along u.
  kFatPlane,
  kBothOrders,  ///< Fat planes with u after v and with v after u; of each bound the tighter one.
};

/// The space between two parallel planes that contains a patch (paper 4, figure 6); mm.
struct FatPlane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< Unit normal of the planes.
  Range distances;  ///< Distances of the two planes from the origin, along the normal.

  [[nodiscard]] double flatness() const { return distances.width(); }
};

/// Returns the unit normal of the diagonals, (V33 − V00) × (V30 − V03). If the diagonals are
/// parallel or 0, returns the normal of the derivatives in the middle, and +Z if these are parallel
/// or 0, too.
[[nodiscard]] Eigen::Vector3d normal_of(const BezierPatch& patch);

/// Returns a fat plane that contains the whole patch.
[[nodiscard]] FatPlane fat_plane(const BezierPatch& patch, FlatnessTest test);

}  // namespace sim::surface::patch
