#include "host-sim/surface/grid_finish.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "host-sim/surface/grid_check.hpp"
#include "host-sim/surface/grid_repair.hpp"
#include "host-sim/surface/outliers.hpp"

namespace sim::surface {
namespace {

/// Greatest height, mm, that is accepted before scaling. Heights up to this limit have finite
/// squares.
constexpr double kFarthestTerrainMm = 1.0e12;

/// Shifts and scales the heights to the range from 0 to the requested height span, if there is one.
void take_height_span(GridDraft& grid) {
  if (grid.height_span_mm == 0.0) return;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const Eigen::Vector3d& point : grid.points) {
    least = std::fmin(least, point.z());
    greatest = std::fmax(greatest, point.z());
  }
  const double scale = greatest > least ? grid.height_span_mm / (greatest - least) : 0.0;
  for (Eigen::Vector3d& point : grid.points) point.z() = (point.z() - least) * scale;
}

/// Refuses missing points or, if `repair`, notes that they will be filled.
void judge_missing(GridDraft& grid, bool repair) {
  FaultyPoints missing;
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    if (grid.is_missing(i)) missing.add(i);
  }
  if (missing.count() == 0) return;
  if (!repair) {
    refuse_points(grid,
                  missing,
                  fmt::format("{} heights are missing", missing.count()),
                  "measure them, or fill them from their neighbours with --repair");
  }
  grid.notes.push_back(fmt::format("{}: {} missing heights are filled from their neighbours, at {}",
                                   grid.name,
                                   missing.count(),
                                   missing.places(grid)));
}

/// Refuses outliers or, if `repair`, notes them and marks them as missing points.
void judge_outliers(GridDraft& grid, bool repair) {
  if (grid.is_picture) return;
  FaultyPoints faults;
  for (const std::size_t index : outliers_of(grid)) {
    faults.add(index);
    if (repair) grid.points[index].z() = std::numeric_limits<double>::quiet_NaN();
  }
  if (faults.count() == 0) return;
  if (!repair) {
    refuse_points(grid,
                  faults,
                  fmt::format("{} heights differ too much from their neighbours", faults.count()),
                  "measure them again, or replace them with --repair");
  }
  grid.notes.push_back(
      fmt::format("{}: {} outliers are replaced by heights from their neighbours, at {}",
                  grid.name,
                  faults.count(),
                  faults.places(grid)));
}

void judge_gaps(GridDraft& grid, bool repair) {
  const FaultyPoints gaps = gaps_of(grid);
  if (gaps.count() == 0) return;
  if (!repair) {
    refuse_points(grid,
                  gaps,
                  fmt::format("has {} gaps of several times the usual spacing, before the points",
                              gaps.count()),
                  "measure there, or bridge them with --repair");
  }
  grid.notes.push_back(fmt::format(
      "{}: {} gaps are bridged, before {}", grid.name, gaps.count(), gaps.places(grid)));
}

/// Reverses the order of rows unless, seen from +Z, the direction of rising row numbers is
/// counter-clockwise from the direction of rising column numbers.
void make_right_handed(GridDraft& grid) {
  if (projected_area(grid) > 0.0) return;
  for (std::size_t row = 0; row < grid.rows / 2; ++row) {
    const auto lower = grid.points.begin() + static_cast<std::ptrdiff_t>(row * grid.columns);
    const auto upper = grid.points.end() - static_cast<std::ptrdiff_t>((row + 1) * grid.columns);
    std::swap_ranges(lower, lower + static_cast<std::ptrdiff_t>(grid.columns), upper);
  }
}

}  // namespace

SurfaceInput finished_grid(GridDraft draft, const ReadOptions& options) {
  // The limit is higher if the heights will be scaled, because terrain may have great heights in
  // the file.
  require_near_points(draft, draft.height_span_mm > 0.0 ? kFarthestTerrainMm : kFarthestMm);
  require_sound_grid(draft);
  judge_gaps(draft, options.repair);
  judge_missing(draft, options.repair);
  take_height_span(draft);
  judge_outliers(draft, options.repair);
  fill_missing(draft);
  take_height_span(draft);
  require_near_points(draft, kFarthestMm);
  make_right_handed(draft);
  SurfaceInput surface;
  surface.grid = PointGrid{draft.rows, draft.columns, std::move(draft.points)};
  surface.mesh = triangulated(*surface.grid);
  surface.notes = std::move(draft.notes);
  return surface;
}

}  // namespace sim::surface
