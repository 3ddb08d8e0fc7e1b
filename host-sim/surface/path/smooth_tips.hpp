#pragma once

#include <Eigen/Core>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/patch/patch_heights.hpp"
#include "host-sim/surface/point_grid.hpp"
#include "planner/surface/grown.hpp"

namespace sim::surface {

/// A smooth surface that a path follows in place of the heights of a tool's tip: bicubic patches
/// in the middle of a band above these heights (paper 4). Noise of the points within half of the
/// band is not milled.
///
/// Where the patches leave the band, as between points at a wall, its border is followed: a path
/// thus cuts in no deeper than without patches, and is higher by no more than the band, in space.
class SmoothTips {
 public:
  struct Hint {
    DropCutter::Hint ceiling{};
    patch::PatchHeights::Hint patches{};
  };

  /// Fits the patches, within half of the band, to the tips of a tool that is larger by as much,
  /// over all points of the grid.
  /// @param tool that the path follows
  /// @param band_mm at right angles to the surface of the tips, above 0
  /// Throws std::invalid_argument for patches that fold in the plan.
  /// @pre the grid has two rows and columns at least
  SmoothTips(const PointGrid& grid, const cnc::surface::GrownTool& tool, double band_mm);

  /// Returns the height over a place, that of the tool's tip before it is raised: at least
  /// `exact_mm`, and cnc::surface::kNoContact where that is.
  /// @param exact_mm height of the tool's tip there
  [[nodiscard]] double height(const Eigen::Vector2d& place, double exact_mm, Hint& hint) const;

  /// Returns the patches; they are the way of the tip, raised.
  [[nodiscard]] const patch::PatchSurface& patches() const { return heights_.surface(); }
  /// Returns the raised tips that the patches fit, and how closely they do.
  [[nodiscard]] const PointGrid& tips() const { return tips_; }
  [[nodiscard]] double fit_mm() const { return 0.5 * band_mm_; }

 private:
  double lift_mm_;
  double band_mm_;
  DropCutter ceiling_;      ///< The tool that is larger by the band.
  double ceiling_lift_mm_;  ///< By which its tip is raised.
  PointGrid tips_;
  patch::PatchHeights heights_;
};

}  // namespace sim::surface
