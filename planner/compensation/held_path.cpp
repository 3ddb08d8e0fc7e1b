#include "planner/compensation/held_path.hpp"

#include <algorithm>

#include "planner/base/contract.hpp"

namespace cnc::compensation {
void HeldPath::begin(const Position& start, Plane plane) {
  axes_ = axes_of(plane);
  start_ = start;
  first_ = size_ = 0;
  forgotten_ = loop_start_ = loop_end_ = rapid_ = 0;
  rounding_ = 0.0F;
}

bool HeldPath::append(const HeldElement& added) {
  if (full()) {
    start_ = at(0).end;
    first_ = (first_ + 1) % kCapacity;
    --size_;
    ++forgotten_;
  }
  at(size_++) = added;
  const std::uint32_t number = newest();
  if (number == 0) return false;
  if (number <= first_nodes_.size()) first_nodes_[number - 1] = start_of(size_ - 1);
  if (added.feed_mm_s <= 0.0F) rapid_ = number;
  if (added.stands || rapid_ == number) return false;
  const std::uint32_t start = start_of_loop();
  if (start == 0) {
    if (loop_end_ == 0 || loop_end_ + 1 != number || !follows_loop()) return false;
    rounding_ = std::max(rounding_, beside_);
    loop_end_ = number;
    return false;
  }
  rounding_ = std::max(rounding_, beside_);
  // Between two outlines are the lead-out of one and the lead-in of the other.
  const bool changed = discard(loop_end_ + 1, start, loop_end_ == 0 ? kLead : 2 * kLead);
  loop_start_ = start;
  loop_end_ = number;
  return changed;
}

bool HeldPath::end_path() {
  return loop_end_ > 0 && size_ > 0 && discard(loop_end_ + 1, newest() + 1, kLead);
}

/// Marks the elements from `first` up to `end` as waste unless they are more than `most`.
bool HeldPath::discard(std::uint32_t first, std::uint32_t end, std::uint32_t most) {
  if (first >= end || end - first > most) return false;
  bool changed = false;
  for (std::uint32_t number = std::max(first, forgotten_); number < end; ++number) {
    HeldElement& held = at(number - forgotten_);
    changed = changed || !held.waste;
    held.waste = true;
  }
  return changed;
}

/// Returns the latest element at whose start the newest one comes by; 0 for none. A loop round the
/// last outline is no outline: a lead-out that ends where a lead-in began.
std::uint32_t HeldPath::start_of_loop() {
  const std::uint32_t least = std::max({1U, loop_start_, rapid_ + 1});
  for (std::size_t i = size_ - 1; i-- > 0 && forgotten_ + i >= least;) {
    if (at(i).stands) continue;
    const Pass pass = pass_by(start_of(i));
    const bool closes = pass == Pass::kEnds || (pass == Pass::kGoesOn && runs_along(i));
    if (closes) return forgotten_ + static_cast<std::uint32_t>(i);
  }
  const auto nodes = static_cast<std::uint32_t>(first_nodes_.size());
  for (std::uint32_t number = std::min(nodes + 1, forgotten_); number-- > least;) {
    if (pass_by(first_nodes_[number - 1]) != Pass::kNever) return number;
  }
  return 0;
}

/// Whether a point is meant to be on a curve; notes how far it is beside it.
bool HeldPath::is_on(const Curve& curve, const Vec2& point) {
  const float off = distance(curve, point);
  beside_ = std::max(beside_, off);
  return off <= kSamePoint;
}

/// How the newest element passes a point at which it does not begin.
HeldPath::Pass HeldPath::pass_by(const Place& node) {
  const Place origin = start_of(size_ - 1);
  const Vec2 point = from(origin, node);
  beside_ = 0.0F;
  if (point.norm() <= kSamePoint) return Pass::kNever;
  const Curve own = curve(size_ - 1, origin);
  if (!is_on(own, point)) return Pass::kNever;
  return (point - own.end).norm() <= kSamePoint ? Pass::kEnds : Pass::kGoesOn;
}

/// Whether the newest element ends on an earlier one and is as much curved.
bool HeldPath::runs_along(std::size_t index) {
  constexpr float kAsCurved = 0.9F;
  const Place origin = start_of(size_ - 1);
  const Curve own = curve(size_ - 1, origin);
  const Curve other = curve(index, origin);
  const float product = own.curvature * other.curvature;
  const float square = std::max(own.curvature * own.curvature, other.curvature * other.curvature);
  return product >= kAsCurved * square && is_on(other, own.end);
}

/// Whether the newest element goes over the last outline once more.
bool HeldPath::follows_loop() {
  const std::size_t first = loop_start_ > forgotten_ ? loop_start_ - forgotten_ : 0;
  const Place origin = start_of(size_ - 1);
  for (std::size_t i = first; i + 1 < size_; ++i) {
    beside_ = 0.0F;
    if (!at(i).stands && is_on(curve(i, origin), Vec2::Zero()) && runs_along(i)) return true;
  }
  return false;
}

bool HeldPath::is_above(const Position& start, const Position& end, std::size_t index) const {
  const auto height = [this](const Position& position) { return position[axes_.normal]; };
  const Coordinate low = std::min(height(start), height(end));
  return low > std::max(height(position(index)), height(at(index).end));
}

std::size_t HeldPath::next(std::size_t index) const {
  do {
    ++index;
  } while (index < size_ && at(index).stands);
  return index;
}

std::size_t HeldPath::previous(std::size_t index) const {
  while (index-- > 0) {
    if (!at(index).stands) return index;
  }
  return size_;
}

Vec2 HeldPath::from(const Place& origin, const Place& place) {
  return {(place[0] - origin[0]).mm(), (place[1] - origin[1]).mm()};
}

Curve HeldPath::curve(std::size_t index, const Place& origin) const {
  const auto arc = Arc::make(
      from(origin, start_of(index)), from(origin, place_of(at(index).end)), at(index).bulge);
  CNC_ASSERT(arc.ok());
  return contour::curve_of(arc.value());
}

}  // namespace cnc::compensation
