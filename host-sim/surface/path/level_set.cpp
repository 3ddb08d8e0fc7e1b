#include "host-sim/surface/path/level_set.hpp"

#include <algorithm>
#include <cmath>

namespace sim::surface {

using Eigen::Vector2d;

/// Divides the path by linear interpolation of the heights. Halves the path where the heights give
/// little information: next to jumps, or if two samples did not halve the path.
Vector2d LevelSet::crossing(Vector2d low, Vector2d high) const {
  constexpr int kMaxLooks = 200;
  double below = above(low);
  double over = above(high);
  double halved = (high - low).norm();
  for (int i = 1; i < kMaxLooks; ++i) {
    const double length = (high - low).norm();
    if (length <= kExact || below == 0.0) break;
    double share = std::clamp(below / (below - over), 0.02, 0.98);
    if (i % 3 == 0) {
      if (length > 0.5 * halved || !std::isfinite(below)) share = 0.5;
      halved = length;
    }
    if (!std::isfinite(below)) share = 0.5;
    const Vector2d look = low + share * (high - low);
    const double found = above(look);
    if (found > 0.0) {
      high = look;
      over = found;
    } else {
      low = look;
      below = found;
    }
  }
  return low;
}

std::optional<Vector2d> LevelSet::near(const Vector2d& place,
                                       const Vector2d& to_low,
                                       double reach_mm) const {
  constexpr int kSteps = 24;
  const bool is_low = above(place) <= 0.0;
  const Vector2d way = is_low ? Vector2d{-to_low} : to_low;
  Vector2d before = place;
  for (int i = 1; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const Vector2d look = place + share * share * reach_mm * way;
    if ((above(look) <= 0.0) != is_low) {
      return is_low ? crossing(before, look) : crossing(look, before);
    }
    before = look;
  }
  return std::nullopt;
}

}  // namespace sim::surface
