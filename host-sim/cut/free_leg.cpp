#include "host-sim/cut/free_leg.hpp"

#include <algorithm>

namespace sim::cut {
namespace {

double distance_at(const RapidEnd* end, std::uint32_t number, double usual) {
  if (end == nullptr) return usual;
  for (const auto& [area, distance] : end->near) {
    if (area == number) return std::min(usual, distance);
  }
  return usual;
}

}  // namespace

RapidEnd FreeLegs::end_at(const Place& place) const {
  RapidEnd end{place, {}};
  const auto note = [&](std::uint32_t number, const LoopArea& area) {
    const double distance = area.distance_to_loop(place) - area.skin_mm();
    if (distance < clearance_mm_) end.near.emplace_back(number, distance);
    return false;
  };
  areas_->visit_near(grown(box_between(place, place), clearance_mm_), note);
  return end;
}

std::optional<std::uint32_t> FreeLegs::area_around(const Place& place,
                                                   std::optional<std::uint32_t> but) const {
  std::optional<std::uint32_t> found;
  areas_->visit_near(box_between(place, place), [&](std::uint32_t number, const LoopArea& area) {
    if (number == but || !area.contains(place)) return false;
    if (area.distance_to_loop(place) <= depth_mm_) return false;
    found = number;
    return true;
  });
  return found;
}

std::optional<std::uint32_t> FreeLegs::area_at(const Place& place) const {
  std::optional<std::uint32_t> found;
  const auto is_at = [&](std::uint32_t number, const LoopArea& area) {
    const double least = clearance_mm_ + area.skin_mm();
    if (!area.contains(place) && area.distance_to_loop(place) >= least) return false;
    found = number;
    return true;
  };
  areas_->visit_near(grown(box_between(place, place), clearance_mm_), is_at);
  return found;
}

std::optional<std::uint32_t> FreeLegs::blocker(const Place& from,
                                               const Place& to,
                                               const RapidEnd* begin,
                                               const RapidEnd* end,
                                               std::optional<std::uint32_t> but) const {
  std::optional<std::uint32_t> found;
  // An end that is nearer to an area than `least` counts as on the edge of the area, because of
  // rounding.
  const double least = depth_mm_;
  constexpr double kSlack = 0.999;
  const auto is_blocked = [&](std::uint32_t number, const LoopArea& area) {
    if (number == but) return false;
    const double keeps = std::min(distance_at(begin, number, clearance_mm_),
                                  distance_at(end, number, clearance_mm_));
    const bool blocked = keeps > least ? area.comes_near(from, to, kSlack * keeps + area.skin_mm())
                                       : area.is_crossed(from, to, depth_mm_);
    if (blocked) found = number;
    return blocked;
  };
  areas_->visit_along(from, to, clearance_mm_, is_blocked);
  return found;
}

}  // namespace sim::cut
