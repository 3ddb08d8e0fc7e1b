#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "host-sim/surface/box_tree.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Greatest error of a distance, mm, without rounding errors.
inline constexpr double kDistanceErrorMm = 1.0e-7;

/// A point of a surface, given by the number of a patch and parameters from 0 to 1, and its
/// distance from the point of the search.
struct SurfacePoint {
  std::uint32_t patch = 0;
  double u = 0.5;
  double v = 0.5;
  double distance_mm = 0.0;
};

/// Computes distances of points from a composite surface.
///
/// A search starts at a known point of the surface, usually the point with the same row and column.
/// It moves this point to the foot of the perpendicular. If this foot is not near enough, a tree of
/// boxes selects few patches. These patches are divided in four while a part could be nearer than
/// the nearest foot so far. A part cannot be nearer if all its control points are beyond a plane
/// whose distance is that of this foot. The plane is perpendicular to the line from the point to
/// the part's foot.
class SurfaceDistance {
 public:
  /// @pre the surface has a patch and outlives this object
  explicit SurfaceDistance(const PatchSurface& surface);

  /// Returns a nearest point of the surface.
  /// @param near a point of the surface at which the search starts; its distance is not used
  [[nodiscard]] SurfacePoint nearest(const Eigen::Vector3d& point, const SurfacePoint& near) const;
  /// Returns a nearest point of the surface. The search needs no starting point.
  [[nodiscard]] SurfacePoint nearest(const Eigen::Vector3d& point) const;
  /// Returns whether the distance between point and surface is at most the tolerance. The answer
  /// may be wrong if the distance differs from the tolerance by less than kDistanceErrorMm.
  [[nodiscard]] bool is_within(const Eigen::Vector3d& point,
                               double tolerance_mm,
                               const SurfacePoint& near) const;

 private:
  struct Part;
  struct Search;

  void search(Search& search) const;
  void search_patch(std::uint32_t number, Search& search) const;

  const PatchSurface* surface_;
  BoxTree tree_;
};

/// Changes the parameters `u` and `v` of a patch, from 0 to 1, by Gauss-Newton steps until the
/// distance from `point` no longer decreases. Returns the distance.
double move_to_foot(const BezierPatch& patch, const Eigen::Vector3d& point, double& u, double& v);

}  // namespace sim::surface::patch
