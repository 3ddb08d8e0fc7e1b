#include "host-sim/surface/path/level_areas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "host-sim/pocket/areas.hpp"
#include "host-sim/surface/path/chord_fit.hpp"
#include "host-sim/surface/path/crossed_contour.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// Distance, mm, up to which two ends of lines count as one point.
constexpr double kOnePlaceMm = 1.0e-6;

Vector2d place_of(const ContourVertex& vertex) { return {vertex.x, vertex.y}; }

/// Returns the area inside the closed line through `places`, mm²; negative if the line is
/// clockwise.
double area_of(const std::vector<Vector2d>& places) {
  double twice = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vector2d from = places[i] - places.front();
    const Vector2d to = places[(i + 1) % places.size()] - places.front();
    twice += from.x() * to.y() - from.y() * to.x();
  }
  return 0.5 * twice;
}

/// A circle that encloses some points.
struct Circle {
  Vector2d centre = Vector2d::Zero();
  double radius = 0.0;
};

Circle circle_around(const std::vector<Vector2d>& places) {
  Circle circle;
  for (const Vector2d& place : places) circle.centre += place;
  circle.centre /= static_cast<double>(places.size());
  for (const Vector2d& place : places) {
    circle.radius = std::max(circle.radius, (place - circle.centre).norm());
  }
  return circle;
}

}  // namespace

LevelAreas::LevelAreas(const SurfaceTracer& tracer,
                       const TipGrid& tips,
                       const LevelBorder& border,
                       double band_mm)
    : tracer_{&tracer}, tips_{&tips}, border_{&border}, band_mm_{band_mm} {
  is_beyond_.reserve(tips.grid().size());
  for (std::size_t node = 0; node < tips.grid().size(); ++node) {
    is_beyond_.push_back(border.beyond(tips.grid().at(node)) > 0.0);
  }
}

std::optional<double> LevelAreas::lowest_mm() const {
  std::optional<double> lowest;
  for (std::size_t node = 0; node < is_beyond_.size(); ++node) {
    if (is_beyond_[node] || !tips_->has_contact(node)) continue;
    lowest = std::min(lowest.value_or(tips_->height(node)), tips_->height(node));
  }
  return lowest;
}

std::optional<std::vector<Contour>> LevelAreas::areas_at(double level_mm) {
  auto contour = contour_at(level_mm);
  if (!contour) return std::nullopt;
  if (contour->loop_ends.empty()) return std::vector<Contour>{};
  if (crosses_itself(*contour)) {
    contour = untangled(*contour, 2.0 * tips_->grid().diagonal());
    if (contour->loop_ends.empty() || crosses_itself(*contour)) return std::nullopt;
  }
  return pocket::areas_of(*contour);
}

/// Returns the contour of a level; nothing if a line is not closed or cannot be approximated within
/// the band.
std::optional<Contour> LevelAreas::contour_at(double level_mm) {
  const LevelSet set{*tracer_, level_mm, border_};
  const auto side_of = [&](std::size_t node) {
    return is_beyond_[node] || tips_->height(node) > level_mm ? NodeSide::kHigh : NodeSide::kLow;
  };
  Contour contour;
  for (LevelLoop& loop : loops_of(set, tips_->grid(), side_of, 0)) {
    if (!loop.is_closed) return std::nullopt;
    if (append_loop(loop, set, contour)) continue;
    if (!is_tiny(loop)) return std::nullopt;
    // A tiny area may be left out. A tiny island must be kept, because the tip would cut into the
    // surface there.
    if (area_of(loop.places) < 0.0 && !append_circle(loop, set, contour)) return std::nullopt;
  }
  return contour;
}

/// Appends a closed loop to a contour as arcs and lines. Returns false if no arcs and lines are
/// within the band.
bool LevelAreas::append_loop(LevelLoop& loop, const LevelSet& set, Contour& to) {
  open_near(loop.places.front(), loop);
  std::vector<ContourVertex> vertices;
  for (const LevelCurve& curve : level_curves(set, loop.places, true, tracer_->density())) {
    const std::vector<ContourVertex> fitted = fitted_to(curve);
    if (!vertices.empty() && !joins(vertices, fitted.front(), set)) return false;
    vertices.insert(vertices.end(), fitted.begin(), fitted.end());
  }
  if (vertices.empty() || !joins(vertices, ContourVertex{vertices.front()}, set)) return false;
  if (vertices.size() < 2) return false;
  to.vertices.insert(to.vertices.end(), vertices.begin(), vertices.end());
  to.end_loop();
  return true;
}

std::vector<ContourVertex> LevelAreas::fitted_to(const LevelCurve& curve) {
  std::vector<ContourVertex> lines;
  std::vector<ContourVertex> arcs;
  fit_chords(curve, curve.all(), band_mm_, lines);
  (void)fitter_.fit(curve, band_mm_, SliceElements::kArcs, arcs);
  return arcs.empty() || lines.size() < arcs.size() ? lines : arcs;
}

/// Returns whether `line` may continue with vertex `next`. This is the case if the line ends at
/// `next` or if the tip may go straight to `next`. In the first case, removes the line's last
/// vertex.
bool LevelAreas::joins(std::vector<ContourVertex>& line,
                       const ContourVertex& next,
                       const LevelSet& set) const {
  const double away = (place_of(next) - place_of(line.back())).norm();
  if (away > kOnePlaceMm) return is_free(set, place_of(line.back()), place_of(next));
  line.pop_back();
  return true;
}

bool LevelAreas::is_tiny(const LevelLoop& loop) const {
  return circle_around(loop.places).radius < 1.5 * tips_->grid().diagonal();
}

/// Appends a circle around a tiny island instead of its line. Returns false if the tip may not go
/// along any of the tried circles.
bool LevelAreas::append_circle(const LevelLoop& loop, const LevelSet& set, Contour& to) const {
  constexpr int kTries = 8;
  constexpr double kGrowth = 1.3;
  const Circle circle = circle_around(loop.places);
  double radius = circle.radius + band_mm_;
  for (int i = 0; i < kTries; ++i, radius *= kGrowth) {
    const double looks = std::ceil(2.0 * std::numbers::pi * radius / tracer_->density().pitch_mm);
    bool is_free = true;
    for (double k = 0.0; k < looks && is_free; k += 1.0) {
      const double angle = 2.0 * std::numbers::pi * k / looks;
      const Vector2d out{std::cos(angle), std::sin(angle)};
      is_free = set.above(circle.centre + radius * out) <= band_mm_;
    }
    if (!is_free) continue;
    to.vertices.push_back({circle.centre.x() - radius, circle.centre.y(), -1.0});
    to.vertices.push_back({circle.centre.x() + radius, circle.centre.y(), -1.0});
    to.end_loop();
    return true;
  }
  return false;
}

/// Returns whether the tip may go straight from `from` to `to`: its height exceeds the level
/// nowhere by more than the band.
bool LevelAreas::is_free(const LevelSet& set, const Vector2d& from, const Vector2d& to) const {
  const double looks = std::ceil((to - from).norm() / tracer_->density().pitch_mm) + 1.0;
  for (double i = 1.0; i < looks; i += 1.0) {
    if (set.above(from + i / looks * (to - from)) > band_mm_) return false;
  }
  return true;
}

}  // namespace sim::surface
