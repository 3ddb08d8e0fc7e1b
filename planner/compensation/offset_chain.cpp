#include "planner/compensation/offset_chain.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/contour/meeting.hpp"
#include "planner/contour/moved_curve.hpp"

namespace cnc::compensation {
namespace {

/// Greatest distance of a swallowed element from the point where the path is cut, as a multiple of
/// the offset. Even at a corner with 30 degrees between its sides, the offset of a line loses less
/// than this length.
constexpr float kReach = 4.0F;

}  // namespace

void OffsetChain::begin(const Position& start, Plane plane, float distance_mm) {
  path_.begin(start, plane);
  settled_ = 0;
  distance_ = distance_mm;
  entry_rounds_ = exit_rounds_ = false;
  trouble_.reset();
}

/// Returns an element as a curve. If the element is an entry that goes around the corner at its
/// end, the end tangent is the one with which the entry reaches the circle about the corner.
Curve OffsetChain::own_curve(std::size_t index, const Place& origin) const {
  Curve own = path_.curve(index, origin);
  if (path_.is_entry(index) && entry_rounds_) own.end_tangent = entry_tangent_;
  return own;
}

bool OffsetChain::has_raw(Name name) const {
  if (path_.at(name.element).stands) return false;
  if (name.kind == Kind::kJoin) {
    return stretch(name).exists && (exit_rounds_ || path_.next(name.element) < size());
  }
  return !contour::is_used_up(path_.curve(name.element, path_.start_of(name.element)), distance_);
}

/// Returns the arc about a corner from the direction `before` to the direction `after`.
Curve OffsetChain::round_about(const Vec2& corner, const Vec2& before, const Vec2& after) const {
  return {corner - distance_ * left_normal(before),
          corner - distance_ * left_normal(after),
          before,
          after,
          1.0F / distance_};
}

/// @pre has_raw(name)
Curve OffsetChain::raw(Name name, const Place& origin) const {
  const Curve own = own_curve(name.element, origin);
  if (name.kind == Kind::kJoin) {
    const std::size_t next = path_.next(name.element);
    return round_about(own.end,
                       own.end_tangent,
                       next < size() ? path_.curve(next, origin).start_tangent : exit_tangent_);
  }
  const Curve moved = contour::moved_aside(own, distance_);
  return path_.is_entry(name.element) && entry_rounds_ ? straight(own.start, moved.end) : moved;
}

float OffsetChain::limit() const { return std::abs(distance_) - kTolerance - path_.rounding(); }

bool OffsetChain::is_clear(const Vec2& place, const Place& origin, bool of_all) const {
  for (std::size_t i = path_.is_entry(0) ? 1 : 0; i < size(); ++i) {
    const bool counts = of_all ? !at(i).stands : path_.is_edge(i);
    if (counts && compensation::distance(path_.curve(i, origin), place) < limit()) return false;
  }
  return true;
}

void OffsetChain::append(const HeldElement& added) {
  if (path_.full()) {
    CNC_ASSERT(settled_ > 0);
    --settled_;
  }
  const bool leads_changed = path_.append(added);
  const std::size_t last = size() - 1;
  if (added.stands) {
    for (Stretch& none : path_.at(last).stretches) none.exists = false;
    return;
  }
  if (path_.is_entry(last)) return add_raw({last, Kind::kParallel}, true);
  if (leads_changed) {
    rebuild();
  } else {
    extend(last);
  }
}

void OffsetChain::finish() {
  if (path_.end_path()) rebuild();
}

/// Recomputes the offsets of all elements that have not been given out, because some of them have
/// turned out to be a lead.
void OffsetChain::rebuild() {
  std::size_t first = settled_;
  while (first < size() && !at(first).stretches[0].live) ++first;
  if (first == size()) return;
  trouble_.reset();
  stretch({first, Kind::kParallel}).end = raw({first, Kind::kParallel}, path_.start_of(first)).end;
  while ((first = path_.next(first)) < size()) extend(first);
}

/// Adds the offset of an element after the offsets of all elements before it.
void OffsetChain::extend(std::size_t index) {
  if (trouble_) {
    path_.at(index).stretches = {};
    return;
  }
  const std::size_t last = path_.previous(index);
  const Place corner = path_.start_of(index);
  const Curve after = path_.curve(index, corner);
  if (path_.is_entry(last)) aim(last, after);
  const Curve before = own_curve(last, corner);
  const float gap = std::abs(distance_) * (before.end_tangent - after.start_tangent).norm();
  const float sine = cross(before.end_tangent, after.start_tangent);
  const bool smooth = gap <= kTouch;
  const bool concave = !smooth && sine * distance_ < 0.0F;
  const Name join{last, Kind::kJoin};
  stretch(join) = {.exists = !smooth && !concave};
  if (stretch(join).exists) add_raw(join, true);
  const Name name{index, Kind::kParallel};
  add_raw(name, !concave);
  // If the entry is too short to reach the intersection of its offset and this element's offset, it
  // leads to the start of this element's offset.
  Stretch& in = stretch({last, Kind::kParallel});
  Stretch& out = stretch(name);
  if (!path_.is_entry(last) || out.live || !has_raw(name)) return;
  in.end = out.start + HeldPath::from(path_.start_of(last), corner);
  out.live = in.live;
}

/// Returns the direction of the line that touches the circle about a corner. From the beginning of
/// the line, the corner is in the direction `direction`, at the distance `length` mm.
/// @param side 1 for a path that arrives at the corner, −1 for a path that leaves it
/// @pre length ≥ |distance()|
Vec2 OffsetChain::round(const Vec2& direction, float length, float side) const {
  const float sine = -side * distance_ / length;
  const float cosine = std::sqrt(std::max(0.0F, 1.0F - sine * sine));
  return cosine * direction + sine * left_normal(direction);
}

/// Determines whether a straight entry has to go around the corner at its end.
void OffsetChain::aim(std::size_t entry, const Curve& after) {
  const Name name{entry, Kind::kParallel};
  const Place origin = path_.start_of(entry);
  const Curve own = path_.curve(entry, origin);
  entry_tangent_ = round(own.end_tangent, own.end.norm(), 1.0F);
  entry_rounds_ = own.curvature == 0.0F && !at(path_.next(entry)).waste &&
                  cross(entry_tangent_, after.start_tangent) * distance_ > 0.0F;
  if (stretch(name).live) stretch(name).end = raw(name, origin).end;
}

/// Adds a raw curve. @param joins whether the raw curve begins where the raw curve before it ends
void OffsetChain::add_raw(Name name, bool joins) {
  Stretch& added = stretch(name);
  added.live = false;
  if (!has_raw(name)) return;
  const Curve curve = raw(name, path_.start_of(name.element));
  added.start = curve.start;
  added.end = curve.end;
  const std::size_t order = name.order();
  std::size_t before = order == 0 ? 0 : order - 1;
  while (before > 0 && !stretch(name_at(before)).exists) --before;
  added.live = order == 0 || (joins && stretch(name_at(before)).live);
  if (!added.live) attach(name);
}

/// Searches for the point where the path leaves an earlier raw curve for this one. If there is
/// none, this is no fault yet, because a later raw curve may swallow this one.
void OffsetChain::attach(Name name) {
  for (std::size_t order = name.order(); order-- > 0;) {
    const Name before = name_at(order);
    if (before.element < settled_) break;
    if (!stretch(before).live) continue;
    if (const auto place = first_meeting(before, name)) return link(before, name, *place);
    // The raw curve `before` could be cut from its start on, so it must not be swallowed.
    if (is_clear(stretch(before).start, path_.start_of(before.element), false)) break;
  }
}

/// Returns the first point that is on both raw curves and not before the beginning of the driven
/// part of `before`. The point is relative to the start of that curve's element.
std::optional<Vec2> OffsetChain::first_meeting(Name before, Name after) const {
  const Place origin = path_.start_of(before.element);
  const Curve a = raw(before, origin);
  const Curve b = raw(after, origin);
  const auto found = contour::meetings_of(a, b, kTouch);
  std::optional<Vec2> first;
  const float order = a.order_of(stretch(before).start);
  float least = 2.0F;
  for (std::uint32_t i = 0; i < found.count; ++i) {
    const float here = a.order_of(found.places[i]);
    if (here < order || here >= least || !is_clear(found.places[i], origin, false)) continue;
    least = here;
    first = found.places[i];
  }
  // If the tangents differ only by rounding, the curves may miss each other.
  const Vec2 gap = b.start - a.end;
  const bool neighbours =
      path_.next(before.element) == after.element && before.kind == Kind::kParallel;
  const bool slight = gap.squaredNorm() <= kTouch * std::max(kTouch, std::abs(distance_)) &&
                      a.end_tangent.dot(b.start_tangent) > 0.0F;
  if (!first && neighbours && slight && is_clear(b.start, origin, false)) first = b.start;
  return first;
}

/// Ends the driven part of `before` at `place` and begins the driven part of `after` there. The raw
/// curves in between are swallowed.
void OffsetChain::link(Name before, Name after, const Vec2& place) {
  const Place origin = path_.start_of(before.element);
  for (std::size_t order = before.order(); order <= after.order(); ++order) {
    const Name name = name_at(order);
    const bool is_before = order == before.order();
    const bool is_after = order == after.order();
    const bool swallowed = !is_before && !is_after;
    if (swallowed && name.kind == Kind::kParallel && !is_beside(place, origin, name.element)) {
      return fail(Reason::kUnreachable, before, name.element, name.element);
    }
    if (!has_raw(name)) continue;
    const Curve curve = raw(name, origin);
    const bool lost =
        (!is_before && !path_.is_entry(before.element) &&
         could_be_cut(curve.start, place, origin)) ||
        (!is_after && could_be_cut(curve.end, place, origin)) ||
        (swallowed && could_be_cut(curve.middle_between(curve.start, curve.end), place, origin));
    if (lost) return fail(Reason::kWouldSplit, before, name.element, after.element);
    if (!is_before) stretch(name).live = is_after;
  }
  stretch(before).end = place;
  stretch(after).start = place + HeldPath::from(path_.start_of(after.element), origin);
}

/// Stores a fault. It is reported when the path after `before` is to be driven.
void OffsetChain::fail(Reason reason, Name before, std::size_t index, std::size_t other) {
  trouble_ = fault(reason, index, other);
  trouble_after_ = path_.forgotten() + static_cast<std::uint32_t>(before.element);
}

/// Returns whether both ends of an element are near the point `cut`. Then the element is a detail
/// of the corner at this point and may be swallowed. Otherwise it belongs to a narrow slot.
bool OffsetChain::is_beside(const Vec2& cut, const Place& origin, std::size_t index) const {
  const float reach = kReach * std::abs(distance_);
  return (HeldPath::from(origin, path_.start_of(index)) - cut).norm() <= reach &&
         (HeldPath::from(origin, path_.start_of(index + 1)) - cut).norm() <= reach;
}

/// Returns whether a point that would be swallowed could be cut. Such a point is not too near to
/// any element, and not next to the point `cut`, where the path is cut anyway.
bool OffsetChain::could_be_cut(const Vec2& lost, const Vec2& cut, const Place& origin) const {
  // At a turn by a slight angle t, the ends that are removed are t · |distance_| long. They are too
  // near by t / 2 times half of that length. If this is at most kTolerance, is_clear() accepts
  // them, although they need not be cut. `brief` is the greatest length of such ends.
  const float brief = 2.0F * std::sqrt(kTolerance * std::abs(distance_)) + kTouch;
  return (lost - cut).norm() > brief && is_clear(lost, origin, true);
}

Fault OffsetChain::fault(Reason reason, std::size_t index, std::size_t other) const {
  const auto number = [this](std::size_t i) {
    return path_.forgotten() + static_cast<std::uint32_t>(i) + 1;
  };
  const auto line = [this](std::size_t i) {
    return i < size() ? std::uint32_t{at(i).line.number} : 0U;
  };
  return {.reason = reason,
          .element = number(index),
          .line = line(index),
          .other = number(other),
          .other_line = line(other)};
}

}  // namespace cnc::compensation
