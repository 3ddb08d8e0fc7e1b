#include "host-sim/surface/path/waterline_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "host-sim/surface/path/chord_fit.hpp"
#include "host-sim/surface/path/level_curve.hpp"
#include "host-sim/surface/path/level_distance.hpp"
#include "host-sim/surface/path/level_loops.hpp"
#include "host-sim/surface/path/loop_leads.hpp"
#include "host-sim/surface/path/loop_order.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// Returns the distance between levels: the step, or the distance that leaves the given scallop.
double distance_of(const RowOptions& options) {
  if (options.scallop_mm == 0.0) return options.step_mm;
  const double distance = level_distance(options.tool, options.scallop_mm - options.tolerance_mm);
  return options.step_mm > 0.0 ? std::min(options.step_mm, distance) : distance;
}

/// Finds the lines of all levels, and plans the path along all lines.
class WaterlinePlanner {
 public:
  WaterlinePlanner(const Mesh& mesh, const RowOptions& options)
      : options_{options},
        tracer_{mesh, options},
        grid_{mesh, options.margin_mm, level_pitch(tracer_)},
        is_low_left_{options.direction != cnc::pocket::Milling::kConventional},
        flat_mm_{kFlatDigits * options.digit_mm},
        lift_mm_{tracer_.lift_mm() - flat_mm_},
        leads_{tracer_, grid_, options, lift_mm_},
        stock_top_mm_{options.stock_top_mm.value_or(top_of(mesh))} {}

  SurfacePath plan() {
    find_loops();
    if (loops_.empty()) refuse_all();
    LoopOrder order{loops_, tracer_.grown_tool().radius_mm};
    Vector2d here = loops_.front().places.front();
    for (std::size_t done = 1; const auto next = order.take_next(here); ++done) {
      add_loop(loops_[*next], here);
      report(0.5 + 0.5 * static_cast<double>(done) / static_cast<double>(loops_.size()));
    }
    end_run();
    if (path_.stretches.empty()) refuse_all();
    return std::move(path_);
  }

 private:
  [[noreturn]] static void refuse_all() {
    throw std::invalid_argument{
        "no level has a line along the surface within the box and the regions; to go around the "
        "surface, give --floor and a --margin greater than the tool's radius"};
  }

  void report(double share) const {
    if (options_.progress) options_.progress(share);
  }

  void find_loops() {
    const TipGrid tips{tracer_, grid_, [this](double share) { report(0.4 * share); }};
    if (!tips.has_any()) throw std::invalid_argument{"the surface is nowhere under the tool"};
    const double depth = tips.highest_mm() - tips.lowest_mm();
    const double levels = std::ceil(depth / distance_of(options_) - 1.0e-9);
    level_distance_mm_ = levels > 0.0 ? depth / levels : 0.0;
    for (double i = 1.0; i <= levels; i += 1.0) {
      const double level = tips.highest_mm() - depth * i / levels;
      for (LevelLoop& loop :
           level_loops(tracer_, tips, static_cast<std::size_t>(i), level + flat_mm_)) {
        if (!is_low_left_) std::ranges::reverse(loop.places);
        for (LevelLoop& part : parts_within(options_.regions, std::move(loop))) {
          loops_.push_back(std::move(part));
        }
      }
      report(0.4 + 0.1 * i / levels);
    }
  }

  /// Adds the curves along a loop. A closed loop begins at its point nearest to `here`. Sets `here`
  /// to the end of the loop.
  void add_loop(LevelLoop& loop, Vector2d& here) {
    if (loop.is_closed) open_near(here, loop);
    const LevelSet set{tracer_, loop.level_mm};
    const auto curves = level_curves(set, loop.places, is_low_left_, tracer_.density());
    if (curves.empty()) return;
    const LevelNode& first = curves.front().nodes().front();
    const auto lead_in = leads_.lead_in({first.place, first.after, loop.level_mm});
    if (lead_in) {
      link_to(lead_in->start());
      path_.stretches.push_back(*lead_in);
    }
    for (const LevelCurve& curve : curves) {
      SurfaceStretch row = stretch_along(curve, loop.level_mm);
      link_to(row.start());
      path_.stretches.push_back(std::move(row));
    }
    const LevelNode& last = curves.back().nodes().back();
    here = last.place;
    const auto lead_out = leads_.lead_out({last.place, last.before, loop.level_mm});
    if (lead_out) path_.stretches.push_back(*lead_out);
  }

  /// Adds a link from the end of the path to `tip` if there is one, else ends the run.
  void link_to(const Eigen::Vector3d& tip) {
    constexpr double kSameHeight = 1.0e-6;
    const bool is_first = path_.stretches.empty();
    const Eigen::Vector3d here = is_first ? tip : path_.stretches.back().end();
    if (!is_first && here == tip) return;
    // A link may descend by at most one level, because stock that is several levels high may be
    // left below a longer descent.
    if (!is_first && here.z() - tip.z() <= level_distance_mm_ + kSameHeight) {
      if (auto way = leads_.way_between(here, tip)) {
        path_.stretches.push_back(std::move(*way));
        return;
      }
    }
    end_run();
  }

  [[nodiscard]] SurfaceStretch stretch_along(const LevelCurve& curve, double level_mm) {
    SurfaceStretch stretch{.plane = LevelPlane{level_mm + lift_mm_}, .vertices = {}};
    const double band = tracer_.band_mm() - flat_mm_;
    std::vector<ContourVertex> lines;
    fit_chords(curve, curve.all(), band, lines);
    if (!options_.lines_only) {
      path_.without_arcs += fitter_.fit(curve, band, SliceElements::kArcs, stretch.vertices);
    }
    if (stretch.vertices.empty() || lines.size() < stretch.vertices.size()) {
      stretch.vertices = std::move(lines);
    }
    return stretch;
  }

  void end_run() {
    const std::size_t begin = path_.runs.empty() ? 0 : path_.runs.back().end;
    if (begin == path_.stretches.size()) return;
    path_.runs.push_back({path_.stretches.size(), stock_top_mm_});
  }

  const RowOptions& options_;
  SurfaceTracer tracer_;
  PlanGrid grid_;
  bool is_low_left_;
  double flat_mm_;
  double lift_mm_;  ///< Height of the path's tip above its level.
  LoopLeads leads_;
  double stock_top_mm_;
  double level_distance_mm_ = 0.0;
  std::vector<LevelLoop> loops_;
  SliceFitter fitter_;
  SurfacePath path_;
};

}  // namespace

SurfacePath waterline_path(const Mesh& mesh, const RowOptions& options) {
  return WaterlinePlanner{mesh, options}.plan();
}

}  // namespace sim::surface
