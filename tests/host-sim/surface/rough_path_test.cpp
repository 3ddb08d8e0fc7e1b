#include "host-sim/surface/path/rough_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "host-sim/pocket/stock_box.hpp"
#include "host-sim/surface/path/level_loops.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"
#include "tests/host-sim/surface/path_judge.hpp"
#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/support/random_cutter.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Calls a function with positions of the tip along stretches.
template <typename Function>
void for_tips(const SurfaceStretch& stretch, double every_mm, const Function& function) {
  for (std::size_t i = 0; i + 1 < stretch.vertices.size(); ++i) {
    const ContourVertex& from = stretch.vertices[i];
    const ContourVertex& to = stretch.vertices[i + 1];
    const cut::Stroke stroke{.from = {from.x, from.y}, .to = {to.x, to.y}, .bulge = from.bulge};
    const int count = 1 + static_cast<int>(cut::length_of(stroke) / every_mm);
    for (int k = 0; k <= count; ++k) {
      const cut::Place place = cut::place_at(stroke, static_cast<double>(k) / count);
      function(Vector3d{place.x(), place.y(), stretch.start().z()});
    }
  }
}

pocket::StockBox box_of(const Mesh& mesh) {
  pocket::StockBox box{1.0e9, 1.0e9, -1.0e9, -1.0e9};
  for (const Vector3d& point : mesh.points) {
    box.include({point.x(), point.y(), point.x(), point.y()});
  }
  return box;
}

/// A job of random form.
struct Job {
  Mesh mesh;
  RowOptions options;
  RoughOptions rough;

  explicit Job(proof::Random& random) {
    mesh = random.chance(0.5) ? random_hills(random) : random_waves(random, 12, 1.0);
    const pocket::StockBox box = box_of(mesh);
    const double size = std::max(box.x1 - box.x0, box.y1 - box.y0);
    do {
      options.tool = proof::random_cutter(random);
      // A steep cone requires a dense grid.
    } while (options.tool.radius_mm > size || options.tool.radius_mm < 0.04 * size ||
             options.tool.rise > 3.0);
    options.tolerance_mm = random.magnitude(options.tool.rise > 0.0 ? 0.04 : 0.004, 0.1);
    options.layer_mm = random.between(0.2, 0.7) * (top_of(mesh) + 1.0);
    const double clearing = clearing_radius(options.tool, options.layer_mm);
    options.step_mm = random.between(0.3, 1.6) * clearing;
    if (random.chance(0.3)) options.floor_mm = random.between(-1.0, 2.0);
    if (random.chance(0.3)) options.margin_mm = random.between(0.1, 3.0);
    if (random.chance(0.3)) options.stock_top_mm = top_of(mesh) + random.between(-0.5, 1.0);
    if (random.chance(0.3) && options.tool.rise == 0.0) {
      options.allowance_mm = random.between(0.0, 0.5);
    }
    if (random.chance(0.3)) options.direction = cnc::pocket::Milling::kConventional;
    options.lines_only = random.chance(0.2);
    if (random.chance(0.4)) rough.stock_margin_mm = random.between(0.0, 2.0);
    if (random.chance(0.3)) add_boundary(random, box);
  }

  /// Returns the path, or an empty one if the surface has none for an expected reason.
  [[nodiscard]] SurfacePath path() const {
    try {
      return rough_path(mesh, options, rough);
    } catch (const std::invalid_argument& error) {
      const std::string reason = error.what();
      // Lines that cross beside a sharp corner enclose no area, and are refused.
      const bool is_expected = reason.starts_with("no part of the surface") ||
                               reason.starts_with("the level at") ||
                               reason.starts_with("the tool fits into no level") ||
                               reason.starts_with("a tolerance of") ||
                               reason.starts_with("paths along contours need a grid of");
      EXPECT_TRUE(is_expected) << reason;
      return {};
    }
  }

 private:
  /// Draws a circle around a point of the box.
  void add_boundary(proof::Random& random, const pocket::StockBox& box) {
    const double width = box.x1 - box.x0;
    const double x = box.x0 + random.between(0.2, 0.8) * width;
    const double y = box.y0 + random.between(0.2, 0.8) * (box.y1 - box.y0);
    const double radius = random.between(0.2, 0.6) * width;
    Contour circle;
    circle.vertices = {{x - radius, y, 1.0}, {x + radius, y, 1.0}};
    circle.end_loop();
    rough.boundary = {circle};
  }
};

TEST(RoughPath, NeverCutsIn) {
  const proof::Trials trials{60};
  double worst = -1.0;
  std::size_t paths = 0;
  std::size_t runs = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Job job{random};
    const SurfacePath path = job.path();
    if (path.runs.empty()) continue;
    ++paths;
    runs += path.runs.size();
    const Judge judge{job.mesh, job.options};
    double deepest = -1.0;
    for_places(text_of(path, job.options),
               0.02 * job.options.tool.radius_mm,
               [&](const Vector3d& tip) { deepest = std::max(deepest, judge.gouge(tip)); });
    EXPECT_LE(deepest, 1.0e-6);
    worst = std::max(worst, deepest);
  }
  if (trials.judges_shares()) {
    EXPECT_GT(paths, 0U);
  }
  std::printf("cuts in by %.3g mm; %zu paths, %zu runs\n", worst, paths, runs);
}

/// Positions of a path by their level, in squares of the plan.
class PlacesByLevel {
 public:
  PlacesByLevel(const SurfacePath& path, double square_mm) : square_mm_{square_mm} {
    for (const SurfaceStretch& stretch : path.stretches) {
      auto& level = levels_[stretch.start().z()];
      for_tips(stretch, 0.02 * square_mm, [&](const Vector3d& tip) {
        level[square_of(tip.head<2>())].emplace_back(tip.head<2>());
      });
    }
  }

  [[nodiscard]] const auto& levels() const { return levels_; }

  /// Returns the distance of the nearest position at a level, up to the length of a square.
  [[nodiscard]] double distance(double level, const Vector2d& place) const {
    const auto& squares = levels_.at(level);
    double least = square_mm_;
    const auto [column, row] = square_of(place);
    for (std::int64_t x = column - 1; x <= column + 1; ++x) {
      for (std::int64_t y = row - 1; y <= row + 1; ++y) {
        const auto found = squares.find({x, y});
        if (found == squares.end()) continue;
        for (const Vector2d& other : found->second) {
          least = std::min(least, (other - place).norm());
        }
      }
    }
    return least;
  }

 private:
  using Square = std::pair<std::int64_t, std::int64_t>;
  [[nodiscard]] Square square_of(const Vector2d& place) const {
    return {static_cast<std::int64_t>(std::floor(place.x() / square_mm_)),
            static_cast<std::int64_t>(std::floor(place.y() / square_mm_))};
  }

  double square_mm_;
  std::map<double, std::map<Square, std::vector<Vector2d>>> levels_;
};

/// Returns whether the grown tool may be at a level at a point and all around it.
bool may_be_around(const SurfaceTracer& tracer, const Vector2d& place, double level, double mm) {
  PathHeights::Hint hint;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / 16.0;
    for (const double out : {0.0, 0.5 * mm, mm}) {
      const Vector2d beside = place + out * Vector2d{std::cos(angle), std::sin(angle)};
      if (tracer.touched(beside, hint) + tracer.lift_mm() > level) return false;
    }
  }
  return true;
}

/// If the tool may be at a point of the stock, and within a cell of the grid around it, the point
/// is within the clearing radius of a pass.
TEST(RoughPath, ClearsAllPlacesOfALevelInWhichTheToolMayBe) {
  const proof::Trials trials{30};
  std::size_t judged = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    Job job{random};
    job.rough.boundary.clear();
    const SurfacePath path = job.path();
    if (path.runs.empty()) continue;
    const double clearing = clearing_radius(job.options.tool, job.options.layer_mm);
    const PlacesByLevel places{path, 1.1 * clearing};
    const SurfaceTracer tracer{job.mesh, job.options};
    const double cell = level_pitch(tracer);
    const pocket::StockBox box = box_of(job.mesh);
    for (const auto& [level, squares] : places.levels()) {
      for (int i = 0; i < 200; ++i) {
        const Vector2d place{random.between(box.x0, box.x1), random.between(box.y0, box.y1)};
        if (!may_be_around(tracer, place, level - 1.0e-9, 2.0 * cell)) continue;
        ++judged;
        EXPECT_LE(places.distance(level, place), 1.001 * clearing)
            << place.transpose() << " at " << level;
      }
    }
  }
  if (trials.judges_shares()) {
    EXPECT_GT(judged, 300U);
  }
  std::printf("%zu places\n", judged);
}

/// The height of a stock over points of the plan, which a tool carves.
class PointStock {
 public:
  PointStock(const pocket::StockBox& box, double top_mm, const cnc::surface::Profile& tool)
      : tool_{tool}, pitch_{(box.x1 - box.x0) / kColumns} {
    for (double y = box.y0; y < box.y1; y += pitch_) {
      for (double x = box.x0; x < box.x1; x += pitch_) points_.push_back({x, y, top_mm});
    }
  }

  void carve(const Vector3d& tip) {
    for (Vector3d& point : points_) {
      const double out = (point - tip).head<2>().norm();
      if (out < tool_.radius_mm) point.z() = std::min(point.z(), tip.z() + height_at(tool_, out));
    }
  }

  /// Returns the depth by which a tool would be in the stock.
  [[nodiscard]] double overlap(const Vector3d& tip) const {
    double most = -1.0e9;
    for (const Vector3d& point : points_) {
      const double out = (point - tip).head<2>().norm();
      if (out < 0.999 * tool_.radius_mm) {
        most = std::max(most, point.z() - tip.z() - height_at(tool_, out));
      }
    }
    return most;
  }

 private:
  static constexpr double kColumns = 24.0;
  cnc::surface::Profile tool_;
  double pitch_;
  std::vector<Vector3d> points_;
};

TEST(RoughPath, BeginsRunsWhereNoStockIsAboveWhatTheySay) {
  const proof::Trials trials{20};
  double worst = -1.0e9;
  std::size_t runs = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Job job{random};
    const SurfacePath path = job.path();
    if (path.runs.empty()) continue;
    const double top = job.options.stock_top_mm.value_or(top_of(job.mesh));
    PointStock stock{pocket::widened(box_of(job.mesh), job.rough.stock_margin_mm.value_or(0.0)),
                     top,
                     job.options.tool};
    std::size_t begin = 0;
    for (const SurfaceRun& run : path.runs) {
      Vector3d start = path.stretches[begin].start();
      start.z() = run.stock_mm;
      // Points along passes are a hundredth of the radius apart.
      EXPECT_LE(stock.overlap(start), 1.0e-3 * (1.0 + job.options.layer_mm)) << start.transpose();
      worst = std::max(worst, stock.overlap(start));
      for (; begin < run.end; ++begin) {
        for_tips(path.stretches[begin],
                 0.05 * job.options.tool.radius_mm,
                 [&](const Vector3d& tip) { stock.carve(tip); });
      }
      ++runs;
    }
  }
  std::printf("%zu runs, the worst begins %.3g mm in the stock\n", runs, worst);
}

}  // namespace
}  // namespace sim::surface
