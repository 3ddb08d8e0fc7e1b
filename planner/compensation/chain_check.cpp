// Which parts of an offset path may be driven, and how it is entered and left.
#include <algorithm>
#include <cmath>

#include "planner/compensation/offset_chain.hpp"
#include "planner/contour/moved_curve.hpp"

namespace cnc::compensation {
namespace {

/// The arc from the origin to a point that ends with a direction; a line where it is straight.
Curve ending_with(const Vec2& end, const Vec2& tangent) {
  Curve way = straight(Vec2::Zero(), end);
  const Vec2 along = way.end_tangent;
  const float length = end.norm();
  if (!(length > 0.0F)) return way;
  way.curvature = 2.0F * cross(along, tangent) / length;
  way.end_tangent = tangent;
  way.start_tangent = 2.0F * along.dot(tangent) * along - tangent;
  return way;
}

/// More than half a turn, as an entry that is too short for its width comes to be.
bool turns_too_far(const Curve& way) {
  constexpr float kRounding = 1.0e-4F;
  const Vec2 chord = way.end - way.start;
  return way.end_tangent.dot(chord) < -kRounding * chord.norm();
}

}  // namespace

Curve OffsetChain::driven(std::size_t index, Kind kind) const {
  const Name name{index, kind};
  Curve way = raw(name, path_.start_of(index));
  way.start_tangent = way.tangent_at(stretch(name).start);
  way.end_tangent = way.tangent_at(stretch(name).end);
  way.start = stretch(name).start;
  way.end = stretch(name).end;
  if (!path_.is_entry(index) || kind != Kind::kParallel) return way;
  return at(index).bulge == 0.0F ? straight(Vec2::Zero(), way.end)
                                 : ending_with(way.end, way.end_tangent);
}

/// The edge that a way comes too near to, if there is one.
/// @param own the way is beside this element, and need not be compared with it
std::optional<std::size_t> OffsetChain::too_near(const Way& way,
                                                 const Place& origin,
                                                 std::size_t own) const {
  for (std::size_t i = 0; i < size(); ++i) {
    if (i == own || !path_.is_edge(i)) continue;
    if (way.rapid && path_.is_above(way.start, way.end, i)) continue;
    if (come_nearer(way.curve, path_.curve(i, origin), limit())) return i;
  }
  return std::nullopt;
}

std::optional<Fault> OffsetChain::check(std::size_t index, bool last) const {
  if (trouble_ && (last || trouble_after_ <= path_.forgotten() + index)) return trouble_;
  if (at(index).stands) return std::nullopt;
  const bool entry = path_.is_entry(index);
  if (entry && !at(index).stretches[0].live) return fault(Reason::kUnreachable, index, index);
  const std::size_t final_one = path_.previous(size());
  if (last && !at(final_one).stretches[0].live) {
    return fault(Reason::kUnreachable, final_one, final_one);
  }
  bool goes_on = last;
  for (std::size_t i = index + 1; i < size(); ++i) {
    goes_on = goes_on || at(i).stretches[0].live || at(i).stretches[1].live;
  }
  const std::size_t next = std::min(path_.next(index), final_one);
  if (!goes_on) return fault(Reason::kUnreachable, next, next);
  const HeldElement& held = at(index);
  for (const Kind kind : {Kind::kParallel, Kind::kJoin}) {
    if (!stretch({index, kind}).live) continue;
    const Way way{driven(index, kind), path_.position(index), held.end, held.feed_mm_s <= 0.0F};
    if (entry && turns_too_far(way.curve)) return fault(Reason::kEntryTooShort, index, index);
    const bool parallel = kind == Kind::kParallel && !entry;
    const auto near = too_near(way, path_.start_of(index), parallel ? index : size());
    if (near) return fault(Reason::kTooNear, index, *near);
  }
  return std::nullopt;
}

OffsetChain::Exit OffsetChain::exit(const Position& here, const Position& to, bool rapid) const {
  const std::size_t last = path_.previous(size());
  const Place origin = path_.start_of(size());
  const Curve own = path_.curve(last, origin);
  const Vec2 target = HeldPath::from(origin, path_.place_of(to));
  const float length = target.norm();
  Vec2 start = HeldPath::from(origin, path_.place_of(here));
  Exit exit;
  if (!at(last).waste && length > std::abs(distance_)) {
    const Vec2 tangent = round(target / length, length, -1.0F);
    // Farther round than a third of a turn is the part.
    if (goes_round(own.end_tangent, tangent) && own.end_tangent.dot(tangent) >= -0.5F) {
      const Vec2 leaving = -distance_ * left_normal(tangent);
      exit.turn = {start, leaving, own.end_tangent, tangent, 1.0F / distance_};
      start = leaving;
    }
  }
  std::optional<std::size_t> near;
  if (exit.turn) near = too_near({*exit.turn, here, here, rapid}, origin, size());
  if (!near) near = too_near({straight(start, target), here, to, rapid}, origin, size());
  if (near) exit.fault = fault(Reason::kTooNear, size(), *near);
  return exit;
}

}  // namespace cnc::compensation
