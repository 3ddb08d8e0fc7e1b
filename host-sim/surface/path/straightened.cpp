#include "host-sim/surface/path/straightened.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sim::surface {
namespace {

using Eigen::Vector2d;

double distance_from_way(const Vector2d& place, const Vector2d& from, const Vector2d& to) {
  const Vector2d way = to - from;
  const double square = way.squaredNorm();
  if (square == 0.0) return (place - from).norm();
  const double share = std::clamp(way.dot(place - from) / square, 0.0, 1.0);
  return (place - from - share * way).norm();
}

}  // namespace

/// Keeps the point that is farthest from the straight line between the ends, and repeats this for
/// both parts until no point is too far. The line of a closed curve is only its start, so that the
/// point farthest from the start is kept.
std::vector<Vector2d> straightened(const std::vector<Vector2d>& places, double tolerance_mm) {
  std::vector<bool> stays(places.size(), false);
  stays.front() = stays.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, places.size() - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double farthest = places[from] == places[to] ? 0.0 : tolerance_mm;
    std::size_t number = 0;
    for (std::size_t i = from + 1; i < to; ++i) {
      const double distance = distance_from_way(places[i], places[from], places[to]);
      if (distance <= farthest) continue;
      farthest = distance;
      number = i;
    }
    if (number == 0) continue;
    stays[number] = true;
    open.emplace_back(from, number);
    open.emplace_back(number, to);
  }
  std::vector<Vector2d> left;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (stays[i] && (left.empty() || left.back() != places[i])) left.push_back(places[i]);
  }
  return left;
}

}  // namespace sim::surface
