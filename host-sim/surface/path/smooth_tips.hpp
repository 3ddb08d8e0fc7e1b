#pragma once

#include <Eigen/Core>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/patch/patch_heights.hpp"
#include "host-sim/surface/point_grid.hpp"
#include "planner/surface/grown.hpp"

namespace sim::surface {

/// A smooth surface that a path follows in place of the heights of a tool's tip: bicubic patches in
/// the middle of a band above these heights (paper 4). Noise of the points within half of the band
/// is not milled.
///
/// Where the patches leave the band, for example between points at a wall, the path follows the
/// border of the band. The path thus cuts no deeper than without patches, and is higher by at most
/// the band, in space.
class SmoothTips {
 public:
  struct Hint {
    DropCutter::Hint ceiling{};
    patch::PatchHeights::Hint patches{};
  };

  /// Fits patches, within half of the band, to the tip positions of a tool that is larger by half
  /// of the band, over all points of the grid.
  /// @param tool the tool that the path follows
  /// @param band_mm width of the band perpendicular to the surface of the tips, above 0
  /// Throws std::invalid_argument for patches that fold in plan.
  /// @pre the grid has at least two rows and columns
  SmoothTips(const PointGrid& grid, const cnc::surface::GrownTool& tool, double band_mm);

  /// Returns the height of the tool's tip over a place before the tip is raised. It is at least
  /// `exact_mm`; if `exact_mm` is cnc::surface::kNoContact, that is returned.
  /// @param exact_mm height of the tool's tip there
  [[nodiscard]] double height(const Eigen::Vector2d& place, double exact_mm, Hint& hint) const;

  /// Returns the patches; they are the surface on which the raised tip moves.
  [[nodiscard]] const patch::PatchSurface& patches() const { return heights_.surface(); }
  /// tips() returns the raised tip positions to which the patches are fitted, fit_mm() the
  /// tolerance of the fit.
  [[nodiscard]] const PointGrid& tips() const { return tips_; }
  [[nodiscard]] double fit_mm() const { return 0.5 * band_mm_; }

 private:
  double lift_mm_;
  double band_mm_;
  DropCutter ceiling_;      ///< The tool that is larger by the band.
  double ceiling_lift_mm_;  ///< Height by which the tip of that tool is raised.
  PointGrid tips_;
  patch::PatchHeights heights_;
};

}  // namespace sim::surface
