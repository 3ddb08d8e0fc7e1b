#pragma once

#include <Eigen/Core>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/patch/patch_heights.hpp"
#include "host-sim/surface/point_grid.hpp"
#include "planner/surface/grown.hpp"

namespace sim::surface {

/// A smooth surface that a path follows instead of the heights of a tool's tip. It consists of
/// bicubic patches in the middle of a band above these heights (paper 4). Noise of the points is
/// not milled if it is at most half of the height of the band.
///
/// Where the patches are outside the band, for example between points at a wall, the path follows
/// the border of the band. The path thus cuts no deeper than without patches. The distance of its
/// points, measured in space, from tip positions at which the tool has contact is at most the
/// height of the band.
class SmoothTips {
 public:
  struct Hint {
    DropCutter::Hint ceiling{};
    patch::PatchHeights::Hint patches{};
  };

  /// Fits patches to the tip positions over all points of the grid, for a tool that is larger by
  /// half of the band. The tolerance of the fit is half of the band.
  /// @param tool the tool that the path follows
  /// @param band_mm width of the band perpendicular to the surface of the tips, above 0
  /// Throws std::invalid_argument for patches that fold in plan.
  /// @pre the grid has at least two rows and columns
  SmoothTips(const PointGrid& grid, const cnc::surface::GrownTool& tool, double band_mm);

  /// Returns the smooth height of the tool's tip over `place`, without the tool's lift. The result
  /// is at least `exact_mm`; it is cnc::surface::kNoContact if `exact_mm` is.
  /// @param exact_mm exact height of the tool's tip over `place`
  [[nodiscard]] double height(const Eigen::Vector2d& place, double exact_mm, Hint& hint) const;

  /// Returns the patches. They form the smooth surface of the raised tip's positions.
  [[nodiscard]] const patch::PatchSurface& patches() const { return heights_.surface(); }
  /// tips() returns the raised tip positions to which the patches are fitted. fit_mm() returns the
  /// tolerance of the fit.
  [[nodiscard]] const PointGrid& tips() const { return tips_; }
  [[nodiscard]] double fit_mm() const { return 0.5 * band_mm_; }

 private:
  double lift_mm_;
  double band_mm_;
  DropCutter ceiling_;      ///< The tool that is larger by the complete band.
  double ceiling_lift_mm_;  ///< Height by which the tip of the tool of ceiling_ is raised.
  PointGrid tips_;
  patch::PatchHeights heights_;
};

}  // namespace sim::surface
