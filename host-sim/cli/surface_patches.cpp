#include "host-sim/cli/surface_patches.hpp"

#include <cstdio>

#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/patch/cartesian_paths.hpp"
#include "host-sim/surface/patch/patch_file.hpp"
#include "host-sim/surface/patch/surface_fit.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

/// Returns the positions of the tip over all points of a grid. The surface is under the tool at
/// each of these positions.
surface::PointGrid tips_over(const surface::PointGrid& grid, const stock::Cutter& cutter) {
  const surface::DropCutter dropped{triangulated(grid), profile_of(cutter)};
  surface::DropCutter::Hint hint;
  surface::PointGrid tips = grid;
  for (Eigen::Vector3d& tip : tips.points) tip.z() = dropped.tip_height(tip.head<2>(), hint);
  return tips;
}

void tell(const surface::patch::FitReport& report, std::size_t patches, double fit_mm) {
  terminal::print(stderr,
                  "{} patches fit {} points within {:g} mm: {:.6f} mm off at most, and {:.6f} mm "
                  "from surface to grid, at row {:.1f} column {:.1f}\n",
                  patches,
                  report.points,
                  fit_mm,
                  report.of_points.distance_mm,
                  report.of_surface.distance_mm,
                  report.of_surface.row + 1.0,
                  report.of_surface.column + 1.0);
}

void tell(const surface::patch::PieceCounts& counts, double flatness_mm) {
  const auto share = [&counts](std::size_t pieces) {
    return static_cast<double>(pieces) / static_cast<double>(counts.control_hull);
  };
  terminal::print(
      "flat pieces within {:g} mm: {} by the hull of control points, {} by the paper's fat plane "
      "({:.3f}), {} by both orders ({:.3f}), {} by halves ({:.3f})\n",
      flatness_mm,
      counts.control_hull,
      counts.fat_plane,
      share(counts.fat_plane),
      counts.both_orders,
      share(counts.both_orders),
      counts.fewest_halvings,
      share(counts.fewest_halvings));
}

}  // namespace

std::shared_ptr<const surface::SmoothTips> smooth_tips(const surface::PointGrid& grid,
                                                       const surface::RowOptions& rows,
                                                       const PatchOptions& options) {
  return std::make_shared<surface::SmoothTips>(grid, traced_tool(rows), options.fit_mm);
}

const surface::patch::PatchSurface& reported_patches(const surface::SmoothTips& smooth,
                                                     const PatchOptions& options) {
  const surface::patch::PatchSurface& patches = smooth.patches();
  tell(surface::patch::fit_report(patches, smooth.tips(), smooth.fit_mm()),
       patches.patches.size(),
       smooth.fit_mm());
  if (!options.file.empty()) write_file(options.file, surface::patch::patch_text(patches));
  return patches;
}

surface::patch::PatchSurface fit_patches(const surface::PointGrid& grid,
                                         const stock::Cutter& cutter,
                                         const PatchOptions& options) {
  const surface::PointGrid tips = tips_over(grid, cutter);
  surface::patch::PatchSurface fitted = surface::patch::fitted_surface(tips, options.fit_mm);
  tell(surface::patch::fit_report(fitted, tips, options.fit_mm),
       fitted.patches.size(),
       options.fit_mm);
  if (!options.file.empty()) write_file(options.file, surface::patch::patch_text(fitted));
  if (options.like_paper) {
    tell(surface::patch::piece_counts(fitted, options.flatness_mm), options.flatness_mm);
  }
  return fitted;
}

}  // namespace sim
