#include "host-sim/surface/path/smooth_tips.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "host-sim/surface/patch/surface_fit.hpp"

namespace sim::surface {
namespace {

/// Returns a larger tool whose raised tip is at most `farthest_mm`, in space, from a contact
/// position of the original tool. A cone is grown by less than `farthest_mm`, because its rim moves
/// outwards and downwards.
cnc::surface::GrownTool grown_within(const cnc::surface::Profile& tool, double farthest_mm) {
  const cnc::surface::GrownTool whole = cnc::surface::grown(tool, farthest_mm);
  if (tool.rise == 0.0) return whole;
  const double share = farthest_mm / std::hypot(whole.band_mm, whole.lift_mm);
  return cnc::surface::grown(tool, share * farthest_mm);
}

/// Returns the raised tip positions over all points of the grid. The tool has contact at each
/// point.
PointGrid tips_over(const PointGrid& grid, const cnc::surface::GrownTool& tool, double lift_mm) {
  const DropCutter cutter{triangulated(grid), tool.profile};
  DropCutter::Hint hint;
  PointGrid tips = grid;
  for (Eigen::Vector3d& tip : tips.points) {
    tip.z() = cutter.tip_height(tip.head<2>(), hint) + tool.lift_mm + lift_mm;
  }
  return tips;
}

}  // namespace

SmoothTips::SmoothTips(const PointGrid& grid, const cnc::surface::GrownTool& tool, double band_mm)
    : lift_mm_{tool.lift_mm},
      band_mm_{band_mm},
      ceiling_{triangulated(grid), grown_within(tool.profile, band_mm).profile},
      ceiling_lift_mm_{grown_within(tool.profile, band_mm).lift_mm},
      tips_{tips_over(grid, grown_within(tool.profile, 0.5 * band_mm), tool.lift_mm)},
      heights_{patch::fitted_surface(tips_, 0.5 * band_mm)} {}

double SmoothTips::height(const Eigen::Vector2d& place, double exact_mm, Hint& hint) const {
  if (exact_mm == cnc::surface::kNoContact) return exact_mm;
  const std::optional<double> found = heights_.height(place, hint.patches);
  const double smooth = found ? *found - lift_mm_ : exact_mm;
  if (smooth <= exact_mm) return exact_mm;
  // The contact height of the larger tool is at least the exact height. So this height need not be
  // computed here.
  if (smooth <= exact_mm + ceiling_lift_mm_) return smooth;
  return std::clamp(smooth, exact_mm, ceiling_.tip_height(place, hint.ceiling) + ceiling_lift_mm_);
}

}  // namespace sim::surface
