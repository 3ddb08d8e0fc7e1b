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
  if (start == 0) return false;
  bool changed = discard(start);
  if (loop_end_ == 0) {
    measure_rounding();
    changed = true;
  }
  loop_start_ = start;
  loop_end_ = number;
  return changed;
}

bool HeldPath::end_path() {
  if (loop_end_ == 0 || !discard(newest() + 1)) return false;
  measure_rounding();
  return true;
}

/// Marks the elements after the last outline (after the entry, if no outline has closed) and before
/// `end` as waste. They are the lead-out of one outline and the lead-in of the next. Does nothing
/// if there are more of them than leads may have. Returns whether a held element has become waste.
bool HeldPath::discard(std::uint32_t end) {
  const std::uint32_t first = loop_end_ + 1;
  if (first >= end || end - first > (loop_end_ == 0 ? kLead : 2 * kLead)) return false;
  bool changed = false;
  for (std::uint32_t number = std::max(first, forgotten_); number < end; ++number) {
    at(number - forgotten_).waste = true;
    changed = true;
  }
  return changed;
}

/// Measures the rounding of the programmed coordinates. It is the greatest distance between an
/// element and the end points of other elements that run along it. Both are lines or both are arcs:
/// for example, an edge and its overlap, or an edge and a tangent line from its middle.
void HeldPath::measure_rounding() {
  for (std::size_t i = 0; i < size_; ++i) {
    if (at(i).stands) continue;
    const Place origin = start_of(i);
    const Curve edge = curve(i, origin);
    for (std::size_t other = 0; other < size_; ++other) {
      const bool alike = (at(other).bulge == 0.0F) == (edge.curvature == 0.0F);
      if (!alike || at(other).stands) continue;
      const Curve along = curve(other, origin);
      for (const Vec2& end : {along.start, along.end}) {
        const float off = distance(edge, end);
        if (off <= kSamePoint) rounding_ = std::max(rounding_, off);
      }
    }
  }
}

/// Returns the number of the latest element whose start point is on the newest element; 0 if there
/// is none. A loop that begins before the last outline is no outline: it arises when a lead-out
/// ends where a lead-in began.
std::uint32_t HeldPath::start_of_loop() const {
  const std::uint32_t least = std::max({std::uint32_t{1}, loop_start_, rapid_ + 1});
  const auto nodes = static_cast<std::uint32_t>(first_nodes_.size());
  for (std::uint32_t number = newest(); number-- > least;) {
    const bool held = number >= forgotten_;
    if (!held && number > nodes) number = nodes;
    const Place& node = held ? start_of(number - forgotten_) : first_nodes_[number - 1];
    if (number >= least && passes(node)) return number;
  }
  return 0;
}

/// Returns whether the newest element passes the point `node`, which is not its own start. If an
/// outline has already closed, the newest element must end at `node`. If none has closed, `node`
/// may also be the beginning of an overlap.
bool HeldPath::passes(const Place& node) const {
  const Place origin = start_of(size_ - 1);
  const Vec2 point = from(origin, node);
  const Curve own = curve(size_ - 1, origin);
  return point.norm() > kSamePoint && distance(own, point) <= kSamePoint &&
         (loop_end_ == 0 || (point - own.end).norm() <= kSamePoint);
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

/// Computes the shape of the curve relative to the curve's own start, because far from the origin
/// both ends may be rounded to one point.
Curve HeldPath::curve(std::size_t index, const Place& origin) const {
  const Place start = start_of(index);
  const Place end = place_of(at(index).end);
  const auto arc = Arc::make(Vec2{0.0F, 0.0F}, from(start, end), at(index).bulge);
  CNC_ASSERT(arc.ok());
  Curve curve = contour::curve_of(arc.value());
  curve.start = from(origin, start);
  curve.end = from(origin, end);
  return curve;
}

}  // namespace cnc::compensation
