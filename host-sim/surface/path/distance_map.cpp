#include "host-sim/surface/path/distance_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// Returns the distance of the origin from the sources, by the best path over a side of a triangle.
/// The distances of the side's ends `first` and `second` are given, and the distance varies
/// linearly between them. The path is straight from the side to the origin.
double distance_from_side(const Vector3d& first,
                          double first_value,
                          const Vector3d& second,
                          double second_value) {
  const Vector3d side = second - first;
  const double length = side.norm();
  const double foot = -first.dot(side) / length;
  const double rise = (second_value - first_value) / length;
  const double across = std::sqrt(std::max(0.0, first.squaredNorm() - foot * foot));
  double along = rise < 0.0 ? length : 0.0;
  if (std::abs(rise) < 1.0) {
    along = std::clamp(foot - rise * across / std::sqrt(1.0 - rise * rise), 0.0, length);
  }
  return first_value + rise * along + std::hypot(across, along - foot);
}

/// Returns the distance from a node with contact to the nearest border of the contact area, along
/// the edges to its neighbours; infinity if all four neighbours have contact.
double beside_border(const SurfaceTracer& tracer, const TipGrid& tips, std::size_t node) {
  constexpr double kNear = 1.0e-6;
  const PlanGrid& grid = tips.grid();
  PathHeights::Hint hint;
  double least = kNowhere;
  for (const std::size_t other :
       {node - 1, node + 1, node - grid.columns(), node + grid.columns()}) {
    if (tips.has_contact(other)) continue;
    Vector2d over = grid.at(node);
    Vector2d beside = grid.at(other);
    while ((beside - over).norm() > kNear) {
      const Vector2d middle = 0.5 * (over + beside);
      const bool is_over = tracer.touched(middle, hint) != cnc::surface::kNoContact;
      (is_over ? over : beside) = middle;
    }
    least = std::min(least, (over - grid.at(node)).norm());
  }
  return least;
}

}  // namespace

/// Propagates distances over the nodes, the nearest node first. If a shorter distance of a node is
/// found later, the node is processed again.
class DistanceMap::March {
 public:
  explicit March(DistanceMap& map) : map_{map} {}

  void start_at(std::size_t node, double distance) { lower(node, distance); }

  void run() {
    while (!front_.empty()) {
      const auto [distance, node] = front_.top();
      front_.pop();
      // Skips an outdated entry: a shorter distance of the node was found later.
      if (distance > map_.distances_[node]) continue;
      for (std::size_t i = 0; i < 8; ++i) update(node, i);
    }
  }

 private:
  using Open = std::pair<double, std::size_t>;

  /// Returns neighbour `number` of a node, counted counter-clockwise from the neighbour in +X.
  /// Returns the node itself if the grid ends there.
  [[nodiscard]] std::size_t neighbour(std::size_t node, std::size_t number) const {
    constexpr std::array<std::array<int, 2>, 8> kSteps{
        {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    const auto& [x, y] = kSteps[number % 8];
    const std::size_t columns = map_.grid().columns();
    const std::size_t column = node % columns;
    const std::size_t row = node / columns;
    const bool is_out = (x < 0 && column == 0) || (x > 0 && column + 1 == columns) ||
                        (y < 0 && row == 0) || (y > 0 && row + 1 == map_.grid().rows());
    if (is_out) return node;
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + x +
                                    y * static_cast<std::ptrdiff_t>(columns));
  }

  /// Updates the distance of neighbour `number` from the distance of node `from`, over the
  /// triangles that contain both nodes.
  void update(std::size_t from, std::size_t number) {
    const std::size_t to = neighbour(from, number);
    if (to == from || !map_.tips_->has_contact(to)) return;
    const double distance = map_.distances_[from];
    if (map_.distances_[to] <= distance) return;
    const Vector3d here = map_.tips_->tip(to);
    const Vector3d first = map_.tips_->tip(from) - here;
    double least = distance + first.norm();
    // The third corner of each of the two triangles is the neighbour of `to` before or after
    // `from`.
    for (const std::size_t beside : {std::size_t{3}, std::size_t{5}}) {
      const std::size_t other = neighbour(to, number + beside);
      if (other == to || map_.distances_[other] == kNowhere) continue;
      const Vector3d second = map_.tips_->tip(other) - here;
      least = std::min(least, distance_from_side(first, distance, second, map_.distances_[other]));
    }
    lower(to, least);
  }

  void lower(std::size_t node, double distance) {
    constexpr double kMinGain = 1.0e-9;
    if (!(distance < map_.distances_[node] - kMinGain)) return;
    map_.distances_[node] = distance;
    front_.emplace(distance, node);
  }

  DistanceMap& map_;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> front_;
};

DistanceMap::DistanceMap(const TipGrid& tips, const std::vector<DistanceSource>& sources)
    : tips_{&tips}, distances_(tips.grid().size(), kNowhere) {
  March march{*this};
  for (const auto& [node, distance] : sources) march.start_at(node, distance);
  march.run();
}

double DistanceMap::greatest() const {
  double greatest = 0.0;
  for (const double distance : distances_) {
    if (distance < kNowhere) greatest = std::max(greatest, distance);
  }
  return greatest;
}

std::vector<DistanceSource> border_sources(const SurfaceTracer& tracer, const TipGrid& tips) {
  std::vector<DistanceSource> sources;
  for (std::size_t node = 0; node < tips.grid().size(); ++node) {
    if (!tips.has_contact(node)) continue;
    const bool is_first = tips.grid().is_on_border(node);
    const double distance = is_first ? 0.0 : beside_border(tracer, tips, node);
    if (distance < kNowhere) sources.push_back({node, distance});
  }
  return sources;
}

}  // namespace sim::surface
