#include "planner/compensation/offset_chain.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/contour/meeting.hpp"
#include "planner/contour/moved_curve.hpp"

namespace cnc::compensation {
namespace {

/// Nearer than the offset by more than this is too near. mm.
constexpr float kTolerance = 5.0e-5F;

/// So many offsets from where the path turns an element may lie that it does not reach: of a corner
/// of 30 degrees that is all that a line would lose, too.
constexpr float kReach = 4.0F;

/// @pre they are not one place, or the tangent means nothing
Curve straight(const Vec2& start, const Vec2& end) {
  const Vec2 way = end - start;
  const float length = way.norm();
  const Vec2 along = length > 0.0F ? Vec2{way / length} : Vec2{1.0F, 0.0F};
  return {start, end, along, along, 0.0F};
}

}  // namespace

void OffsetChain::begin(const Place& start, float distance_mm) {
  first_ = size_ = settled_ = 0;
  forgotten_ = 0;
  start_ = start;
  distance_ = distance_mm;
}

Vec2 OffsetChain::from(const Place& origin, const Place& place) {
  return {(place[0] - origin[0]).mm(), (place[1] - origin[1]).mm()};
}

Curve OffsetChain::element(std::size_t index, const Place& origin) const {
  const auto arc =
      Arc::make(from(origin, start_of(index)), from(origin, at(index).end), at(index).bulge);
  CNC_ASSERT(arc.ok());
  return contour::curve_of(arc.value());
}

bool OffsetChain::has_raw(Name name) const {
  if (name.kind == Kind::kJoin) return stretch(name).exists && name.element + 1 < size_;
  return !contour::is_used_up(element(name.element, start_of(name.element)), distance_);
}

/// @pre has_raw(name)
Curve OffsetChain::raw(Name name, const Place& origin) const {
  const Curve own = element(name.element, origin);
  if (name.kind == Kind::kParallel) return contour::moved_aside(own, distance_);
  return contour::round_join(own, element(name.element + 1, origin), distance_);
}

/// Nowhere nearer to what is known of the path than the offset.
bool OffsetChain::is_clear(const Vec2& place, const Place& origin) const {
  for (std::size_t i = is_entry(0) ? 1 : 0; i < size_; ++i) {
    const float off = compensation::distance(element(i, origin), place);
    if (off < std::abs(distance_) - kTolerance) return false;
  }
  return true;
}

std::optional<Fault> OffsetChain::append(const HeldElement& added) {
  if (size_ == kCapacity) {
    CNC_ASSERT(settled_ > 0);
    --settled_;
    start_ = at(0).end;
    first_ = (first_ + 1) % kCapacity;
    --size_;
    ++forgotten_;
  }
  at(size_++) = added;
  const std::size_t last = size_ - 1;
  if (last == 0) return add_raw({0, Kind::kParallel}, true);
  const Place& corner = start_of(last);
  const Curve before = element(last - 1, corner);
  const Curve after = element(last, corner);
  const float gap = std::abs(distance_) * (before.end_tangent - after.start_tangent).norm();
  const float sine = cross(before.end_tangent, after.start_tangent);
  const bool smooth = gap <= kTouch;
  const bool concave = !smooth && sine * distance_ < 0.0F;
  const Name join{last - 1, Kind::kJoin};
  stretch(join) = {.exists = !smooth && !concave};
  if (stretch(join).exists) {
    if (const auto fault = add_raw(join, true)) return fault;
  }
  return add_raw({last, Kind::kParallel}, !concave);
}

/// @param joins it begins where the raw curve before it ends
std::optional<Fault> OffsetChain::add_raw(Name name, bool joins) {
  Stretch& added = stretch(name);
  added.live = false;
  if (!has_raw(name)) return std::nullopt;
  const Curve curve = raw(name, start_of(name.element));
  added.start = curve.start;
  added.end = curve.end;
  const std::size_t order = name.order();
  std::size_t before = order == 0 ? 0 : order - 1;
  if (before > 0 && !stretch(name_at(before)).exists) --before;
  added.live = order == 0 || (joins && stretch(name_at(before)).live);
  return added.live ? std::nullopt : attach(name);
}

/// Finds where the path leaves a curve for this one. Nothing to be found is no fault: what
/// follows may swallow this one.
std::optional<Fault> OffsetChain::attach(Name name) {
  for (std::size_t order = name.order(); order-- > 0;) {
    const Name before = name_at(order);
    if (before.element < settled_) break;
    if (!stretch(before).live) continue;
    if (const auto place = first_meeting(before, name)) return link(before, name, *place);
    // From here on it could be cut, so that it is not swallowed.
    if (is_clear(stretch(before).start, start_of(before.element))) break;
  }
  return std::nullopt;
}

/// The first place that is on both, beyond where the first begins, as seen from its element.
std::optional<Vec2> OffsetChain::first_meeting(Name before, Name after) const {
  const Place& origin = start_of(before.element);
  const Curve a = raw(before, origin);
  const Curve b = raw(after, origin);
  const auto found = contour::meetings_of(a, b, kTouch);
  std::optional<Vec2> first;
  const float order = a.order_of(stretch(before).start);
  float least = 2.0F;
  for (std::uint32_t i = 0; i < found.count; ++i) {
    const float here = a.order_of(found.places[i]);
    if (here < order || here >= least || !is_clear(found.places[i], origin)) continue;
    least = here;
    first = found.places[i];
  }
  // Tangents that differ by rounding only, whose curves miss each other.
  const Vec2 gap = b.start - a.end;
  const bool neighbours = before.element + 1 == after.element && before.kind == Kind::kParallel;
  const bool slight = gap.squaredNorm() <= kTouch * std::max(kTouch, std::abs(distance_)) &&
                      a.end_tangent.dot(b.start_tangent) > 0.0F;
  if (!first && neighbours && slight && is_clear(b.start, origin)) first = b.start;
  return first;
}

/// Drives one curve to a place, and another one from there on; swallows what is between.
std::optional<Fault> OffsetChain::link(Name before, Name after, const Vec2& place) {
  const Place& origin = start_of(before.element);
  for (std::size_t order = before.order(); order <= after.order(); ++order) {
    const Name name = name_at(order);
    const bool is_before = order == before.order();
    const bool is_after = order == after.order();
    const bool swallowed = !is_before && !is_after;
    if (swallowed && name.kind == Kind::kParallel && !is_beside(place, origin, name.element)) {
      return fault(Reason::kUnreachable, name.element, name.element);
    }
    if (!has_raw(name)) continue;
    const Curve curve = raw(name, origin);
    const bool lost =
        (!is_before && !is_entry(before.element) && could_be_cut(curve.start, place, origin)) ||
        (!is_after && could_be_cut(curve.end, place, origin)) ||
        (swallowed && could_be_cut(curve.middle_between(curve.start, curve.end), place, origin));
    if (lost) return fault(Reason::kWouldSplit, name.element, after.element);
    if (!is_before) stretch(name).live = is_after;
  }
  stretch(before).end = place;
  stretch(after).start = place + from(start_of(after.element), origin);
  return std::nullopt;
}

/// Whether an element is a detail of the corner that is cut there, and no slot.
bool OffsetChain::is_beside(const Vec2& cut, const Place& origin, std::size_t index) const {
  const float reach = kReach * std::abs(distance_);
  return (from(origin, start_of(index)) - cut).norm() <= reach &&
         (from(origin, at(index).end) - cut).norm() <= reach;
}

/// Whether a place that is swallowed is clear, and not where the path is cut anyway.
bool OffsetChain::could_be_cut(const Vec2& lost, const Vec2& cut, const Place& origin) const {
  // Ends of a slight turn are as good as clear: half of it times half of what it takes off.
  const float brief = 2.0F * std::sqrt(kTolerance * std::abs(distance_)) + kTouch;
  return (lost - cut).norm() > brief && is_clear(lost, origin);
}

Curve OffsetChain::driven(std::size_t index, Kind kind) const {
  const Place& origin = start_of(index);
  const Name name{index, kind};
  Curve way = raw(name, origin);
  way.start_tangent = way.tangent_at(stretch(name).start);
  way.end_tangent = way.tangent_at(stretch(name).end);
  way.start = stretch(name).start;
  way.end = stretch(name).end;
  if (!is_entry(index) || kind != Kind::kParallel) return way;
  return straight(Vec2::Zero(), way.end);
}

/// The element that a way comes too near to, if there is one.
/// @param own the way is beside this element, and need not be compared with it
std::optional<std::size_t> OffsetChain::too_near(const Curve& way,
                                                 const Place& origin,
                                                 std::size_t own) const {
  const float limit = std::abs(distance_) - kTolerance;
  for (std::size_t i = is_entry(0) ? 1 : 0; i < size_; ++i) {
    if (i != own && come_nearer(way, element(i, origin), limit)) return i;
  }
  return std::nullopt;
}

/// The same of an entry or exit: aslant to its end beside an element it passes the end of that
/// element a little nearer, as it does in LinuxCNC.
std::optional<std::size_t> OffsetChain::too_near_aslant(const Curve& way,
                                                        const Place& origin,
                                                        std::size_t touched,
                                                        const Vec2& corner) const {
  if (const auto near = too_near(way, origin, touched)) return near;
  const float aside = std::min(std::abs(distance_), compensation::distance(way, corner));
  const float limit = aside - kTolerance;
  const bool is_near = touched < size_ && come_nearer(way, element(touched, origin), limit);
  return is_near ? std::optional{touched} : std::nullopt;
}

std::optional<Fault> OffsetChain::check(std::size_t index, bool last) const {
  const bool lives_last = at(size_ - 1).stretches[0].live;
  if (last && !lives_last) return fault(Reason::kUnreachable, size_ - 1, size_ - 1);
  bool goes_on = last;
  for (std::size_t i = index + 1; i < size_; ++i) {
    goes_on = goes_on || at(i).stretches[0].live || at(i).stretches[1].live;
  }
  const std::size_t next = index + 1 < size_ ? index + 1 : index;
  if (!goes_on) return fault(Reason::kUnreachable, next, next);
  for (const Kind kind : {Kind::kParallel, Kind::kJoin}) {
    if (!stretch({index, kind}).live) continue;
    const Place& origin = start_of(index);
    const Curve way = driven(index, kind);
    const bool entry = is_entry(index) && kind == Kind::kParallel;
    const auto near = entry ? too_near_aslant(way, origin, index + 1, from(origin, at(index).end))
                            : too_near(way, origin, kind == Kind::kParallel ? index : size_);
    if (near) return fault(Reason::kTooNear, index, *near);
  }
  return std::nullopt;
}

std::optional<Fault> OffsetChain::check_exit(const Place& to) const {
  const std::size_t last = size_ - 1;
  const Place& origin = start_of(last);
  const Curve way = straight(stretch({last, Kind::kParallel}).end, from(origin, to));
  const auto near = too_near_aslant(way, origin, last, from(origin, at(last).end));
  if (near) return fault(Reason::kTooNear, size_, *near);
  return std::nullopt;
}

Fault OffsetChain::fault(Reason reason, std::size_t index, std::size_t other) const {
  const auto number = [this](std::size_t i) {
    return forgotten_ + static_cast<std::uint32_t>(i) + 1;
  };
  const auto line = [this](std::size_t i) {
    return i < size_ ? std::uint32_t{at(i).line.number} : 0U;
  };
  return {.reason = reason,
          .element = number(index),
          .line = line(index),
          .other = number(other),
          .other_line = line(other)};
}

}  // namespace cnc::compensation
