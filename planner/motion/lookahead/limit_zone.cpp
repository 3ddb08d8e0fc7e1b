#include "planner/motion/lookahead/limit_zone.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::motion {
namespace {

/// Returns whether `other` is at least as long as `zone` and has limits that are at least as
/// strict.
bool is_within(const LimitZone& zone, const LimitZone& other) {
  return zone.length <= other.length && zone.speed_square >= other.speed_square &&
         zone.acceleration >= other.acceleration &&
         both(zone.turning, other.turning) == other.turning;
}

/// Returns a limit zone with the stricter limits of both zones and the length of the longer one.
LimitZone both(const LimitZone& a, const LimitZone& b) {
  return {.length = std::max(a.length, b.length),
          .speed_square = std::min(a.speed_square, b.speed_square),
          .acceleration = std::min(a.acceleration, b.acceleration),
          .turning = both(a.turning, b.turning)};
}

bool binds(const LimitZone& zone, const LimitZone& own) {
  return zone.speed_square < own.speed_square || zone.acceleration < own.acceleration ||
         zone.turning.curvature > 0.0F;
}

/// Returns the time per distance that the limits of a limit zone cost, in s/mm. It is the sum of
/// two values of 1/v. The first v is the speed of the zone. The second v is the speed at which
/// turning uses all acceleration, which does not depend on overrides.
float pace_within(const LimitZone& zone) {
  return 1.0F / std::sqrt(zone.speed_square) + std::sqrt(zone.turning.speed_ratio);
}

/// Returns the time in s that is lost if the limits of the shorter zone also hold over the length
/// of the longer zone.
float price_of_both(const LimitZone& a, const LimitZone& b) {
  const LimitZone& longer = a.length < b.length ? b : a;
  return std::abs(a.length - b.length) * (pace_within(both(a, b)) - pace_within(longer));
}

}  // namespace

void ZoneTrail::remove(std::size_t index) { zones_[index] = zones_[--count_]; }

void ZoneTrail::add(const LimitZone& zone) {
  if (zone.length <= 0.0F) return;
  for (std::size_t i = count_; i-- > 0;) {
    if (zones_[i].whole <= zone.length && is_within(zone, zones_[i].zone)) return;
    if (zones_[i].whole >= zone.length && is_within(zones_[i].zone, zone)) remove(i);
  }
  zones_[count_++] = {zone, zone.length};
  if (count_ > kCapacity) merge_cheapest();
}

/// Merges the two limit zones for which merging costs the least time. The result is at least as
/// strict as each of them everywhere.
void ZoneTrail::merge_cheapest() {
  std::size_t first = 0;
  std::size_t second = 1;
  float least = 1.0e12F;
  for (std::size_t i = 0; i < count_; ++i) {
    for (std::size_t k = i + 1; k < count_; ++k) {
      const float price = price_of_both(zones_[i].zone, zones_[k].zone);
      if (price >= least) continue;
      least = price;
      first = i;
      second = k;
    }
  }
  const float whole = std::min(zones_[first].whole, zones_[second].whole);
  zones_[first] = {both(zones_[first].zone, zones_[second].zone), whole};
  remove(second);
}

/// A limit zone also ends by time. When the plan has been beyond a position for the whole time
/// window, the mean of the plan contains no position before it, even if the plan has driven only a
/// short distance. If the plan keeps its speed, half of the window is enough.
void ZoneTrail::advance(float length, float reach) {
  const float window_share = reach > 0.0F ? 0.5F * length / reach : 0.0F;
  for (std::size_t i = count_; i-- > 0;) {
    LimitZone& zone = zones_[i].zone;
    zone.length -= std::max(length, window_share * zones_[i].whole);
    if (zone.length <= 0.0F) remove(i);
  }
}

BlockZones ZoneTrail::reaching(const LimitZone& own) const {
  ZoneTrail binding;
  for (std::size_t i = 0; i < count_; ++i) {
    if (binds(zones_[i].zone, own)) binding.zones_[binding.count_++] = zones_[i];
  }
  BlockZones found{};
  while (binding.count_ > found.size()) binding.merge_cheapest();
  for (std::size_t i = 0; i < binding.count_; ++i) found[i] = binding.zones_[i].zone;
  return found;
}

}  // namespace cnc::motion
