#include "host-sim/surface/path/parallel_path.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "host-sim/surface/path/distance_loops.hpp"
#include "host-sim/surface/path/loop_order.hpp"
#include "host-sim/surface/path/scallop_rows.hpp"
#include "host-sim/surface/path/straightened.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"
#include "host-sim/surface/path/tip_grid.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// Maximum length of a link over the surface, in steps. The path to a line that is farther away
/// begins with a lift.
constexpr double kLinkSteps = 4.0;
/// Greatest deviation of a straight path from a line, in steps.
constexpr double kStraightShare = 0.01;
/// Length of a step, in distances between neighbouring nodes of the grid.
constexpr double kNodesPerStep = 7.0;
/// Distance between lines, in steps. It is below 1, because a point between the right-angled
/// corners of two neighbouring lines may be 0.59 times the lines' distance away from both lines.
constexpr double kNearer = 0.9;
/// Maximum distance of a point from a line, in steps. It allows the distance between right-angled
/// corners, kNearer · 0.59, because additional lines at all these corners would be many.
constexpr double kFarthest = 0.53;

/// Plans the path along the lines of equal distance, one line after another.
class ParallelPlanner {
 public:
  ParallelPlanner(const Mesh& mesh, const RowOptions& options)
      : options_{options},
        step_mm_{kNearer * step_of(options)},
        tracer_{mesh, options},
        loops_{distance_loops(
            tracer_,
            TipGrid{tracer_, PlanGrid{mesh, options.margin_mm, step_mm_ / kNodesPerStep}, {}},
            step_mm_,
            kFarthest * step_of(options))},
        stock_top_mm_{options.stock_top_mm.value_or(top_of(mesh))} {}

  SurfacePath plan() {
    if (options_.direction == cnc::pocket::Milling::kConventional) {
      for (LevelLoop& loop : loops_) std::ranges::reverse(loop.places);
    }
    LoopOrder order{loops_, 1.5 * step_mm_};
    Vector2d here = Vector2d::Zero();
    for (std::size_t done = 1; const auto next = order.take_next(here); ++done) {
      add_loop(loops_[*next], here);
      if (!path_.stretches.empty()) here = path_.stretches.back().end().head<2>();
      if (options_.progress) {
        options_.progress(static_cast<double>(done) / static_cast<double>(loops_.size()));
      }
    }
    if (path_.stretches.empty()) {
      throw std::invalid_argument{
          "no line is over the surface, because the surface is narrower than about half a step; "
          "choose a smaller --step"};
    }
    end_run();
    path_.without_arcs = tracer_.without_arcs();
    return std::move(path_);
  }

 private:
  /// Adds a line to the path. A closed line begins at its point nearest to `here`.
  void add_loop(LevelLoop& loop, const Vector2d& here) {
    if (loop.is_closed) open_near(here, loop);
    const std::vector<Vector2d> corners = straightened(loop.places, kStraightShare * step_mm_);
    lead_to(corners.front());
    for (std::size_t i = 1; i < corners.size(); ++i) add_way(corners[i - 1], corners[i]);
  }

  /// Adds the parts of a straight path that are over the surface and in all regions.
  void add_way(const Vector2d& from, const Vector2d& to) {
    const Slice slice = slice_between(from, to);
    for (const auto& [begin, end] :
         common_parts(options_.regions, slice, tracer_.parts_over(slice))) {
      add_stretch(tracer_.trace(slice, begin, end, StretchUse::kRow));
    }
  }

  /// Adds a link over the surface to `place` if it is near, the surface continues up to it and no
  /// region bars the link.
  void lead_to(const Vector2d& place) {
    if (path_.stretches.empty()) return;
    const Vector2d here = path_.stretches.back().end().head<2>();
    const double distance = (place - here).norm();
    if (distance == 0.0 || distance > kLinkSteps * step_mm_) return;
    const Slice slice = slice_between(here, place);
    if (!lets_link_through(options_.regions, slice)) return;
    const auto parts = tracer_.parts_over(slice);
    if (parts.size() != 1 || parts[0].second - parts[0].first < 0.999 * slice.length) return;
    add_stretch(tracer_.trace(slice, 0.0, slice.length, StretchUse::kLink));
  }

  /// Adds a stretch. Ends the run first, which causes a lift, if the stretch does not begin at the
  /// tip's present position.
  void add_stretch(SurfaceStretch stretch) {
    constexpr double kSameTip = 1.0e-6;
    if (!path_.stretches.empty() &&
        (path_.stretches.back().end() - stretch.start()).norm() > kSameTip) {
      end_run();
    }
    path_.stretches.push_back(std::move(stretch));
  }

  void end_run() {
    const std::size_t begin = path_.runs.empty() ? 0 : path_.runs.back().end;
    if (begin == path_.stretches.size()) return;
    path_.runs.push_back({path_.stretches.size(), stock_top_mm_});
  }

  const RowOptions& options_;
  double step_mm_;
  SurfaceTracer tracer_;
  std::vector<LevelLoop> loops_;
  double stock_top_mm_;
  SurfacePath path_;
};

}  // namespace

SurfacePath parallel_path(const Mesh& mesh, const RowOptions& options) {
  return ParallelPlanner{mesh, options}.plan();
}

}  // namespace sim::surface
