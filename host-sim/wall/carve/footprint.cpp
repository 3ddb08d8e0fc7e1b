#include "host-sim/wall/carve/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace sim::wall {
namespace {

using Eigen::Vector2d;

/// Number of sides of the polygon around a disc. The polygon is at most 2 % wider than the disc.
constexpr int kSides = 16;

/// Returns twice the signed area of a triangle; > 0 if its corners are counter-clockwise.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Appends one half of the convex hull to `hull`, from the first of the sorted points to the last.
template <typename Iterator>
void add_half(Iterator point, Iterator end, std::vector<Vector2d>& hull) {
  const std::size_t first = hull.size();
  for (; point != end; ++point) {
    while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), *point) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(*point);
  }
  hull.pop_back();
}

}  // namespace

Footprint::Footprint(const std::array<SweptCone::Disc, 4>& discs) {
  constexpr double kStep = 2.0 * std::numbers::pi / kSides;
  std::vector<Vector2d> points;
  points.reserve(kSides * discs.size());
  for (const SweptCone::Disc& disc : discs) {
    // The radius is slightly increased, so that no column is missed because of rounding.
    const double radius = disc.radius_mm / std::cos(0.5 * kStep) + 1.0e-9;
    for (int i = 0; i < kSides; ++i) {
      points.emplace_back(disc.middle +
                          radius * Vector2d{std::cos(i * kStep), std::sin(i * kStep)});
    }
  }
  std::ranges::sort(points, [](const Vector2d& a, const Vector2d& b) {
    return std::pair{a.x(), a.y()} < std::pair{b.x(), b.y()};
  });
  add_half(points.begin(), points.end(), corners_);
  add_half(points.rbegin(), points.rend(), corners_);
  const auto [low, high] =
      std::ranges::minmax(corners_, {}, [](const Vector2d& corner) { return corner.y(); });
  y_min_ = low.y();
  y_max_ = high.y();
}

std::optional<Footprint::Reach> Footprint::along(double y) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Reach reach{kFar, -kFar};
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vector2d& a = corners_[i];
    const Vector2d& b = corners_[(i + 1) % corners_.size()];
    if ((a.y() < y) == (b.y() < y)) continue;
    const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    reach.from = std::min(reach.from, x);
    reach.until = std::max(reach.until, x);
  }
  if (reach.from > reach.until) return {};
  return reach;
}

}  // namespace sim::wall
