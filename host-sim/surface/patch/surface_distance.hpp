#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "host-sim/surface/box_tree.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// Largest error of a distance, mm, but for rounding.
inline constexpr double kDistanceErrorMm = 1.0e-7;

/// A point of a surface, by a patch and its parameters from 0 to 1, and its distance from another
/// point.
struct SurfacePoint {
  std::uint32_t patch = 0;
  double u = 0.5;
  double v = 0.5;
  double distance_mm = 0.0;
};

/// Distances of points from a composite surface.
///
/// A search starts at a known point of the surface, mostly the one with the same row and column,
/// and moves it to the foot of the perpendicular. Where that does not settle it, a tree of boxes
/// leaves few patches. These are divided in four as long as a part could be nearer: all its control
/// points and thus the part lie beyond a plane across the line to its foot.
class SurfaceDistance {
 public:
  /// @pre the surface has a patch. It must live as long as this object.
  explicit SurfaceDistance(const PatchSurface& surface);

  /// Returns a nearest point of the surface.
  /// @param near a point of the surface to start at; its distance is not used
  [[nodiscard]] SurfacePoint nearest(const Eigen::Vector3d& point, const SurfacePoint& near) const;
  /// Returns a nearest point of the surface without a known one to start at.
  [[nodiscard]] SurfacePoint nearest(const Eigen::Vector3d& point) const;
  /// Returns whether the surface comes within the tolerance of the point. This is exact unless the
  /// distance differs from the tolerance by less than kDistanceErrorMm.
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

/// Moves a point of a patch, u and v within 0 to 1, by Gauss-Newton steps to where no step makes it
/// nearer, and returns the distance.
double move_to_foot(const BezierPatch& patch, const Eigen::Vector3d& point, double& u, double& v);

}  // namespace sim::surface::patch
