#include "planner/motion/lookahead/neighbour_zones.hpp"

#include <algorithm>

namespace cnc::motion {

LimitZone NeighbourZones::between(float from, float to, float length) const {
  LimitZone found;
  const auto take = [&found](const LimitZone& zone) {
    found.speed_square = std::min(found.speed_square, zone.speed_square);
    found.acceleration = std::min(found.acceleration, zone.acceleration);
    found.turning = both(found.turning, zone.turning);
  };
  for (const LimitZone& zone : head_) {
    if (zone.length > from) take(zone);
  }
  for (const LimitZone& zone : tail_) {
    if (zone.length > 0.0F && length - zone.length < to) take(zone);
  }
  return found;
}

float steepest_in(const LimitZone& zone, float most, const SpeedChange& change, float window_s) {
  const float within = std::min(most, zone.acceleration);
  const float lag = lag_of(zone.turning.curvature, within, window_s);
  return zone.turning.steepest(
      within, change.growing, change.speed_square, change.cap_square, window_s, lag);
}

}  // namespace cnc::motion
