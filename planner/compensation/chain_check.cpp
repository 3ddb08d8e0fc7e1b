// Checks which parts of an offset path may be driven, and how the path is entered and left.
#include <algorithm>
#include <cmath>

#include "planner/compensation/offset_chain.hpp"
#include "planner/contour/moved_curve.hpp"

namespace cnc::compensation {
namespace {

/// Tolerance, as a cosine, of the check that an entry arc makes at most half a turn. An entry that
/// is too short for the offset turns by more.
constexpr float kHalfTurn = 1.0e-4F;
constexpr float kThirdOfATurn = -0.5F;  ///< Cosine of a third of a turn.

}  // namespace

Curve OffsetChain::driven(std::size_t index, Kind kind) const {
  const Name name{index, kind};
  Curve way = raw(name, path_.start_of(index));
  way.start_tangent = way.tangent_at(stretch(name).start);
  way.end_tangent = way.tangent_at(stretch(name).end);
  way.start = stretch(name).start;
  way.end = stretch(name).end;
  if (!path_.is_entry(index) || kind != Kind::kParallel) return way;
  const Vec2 tangent = way.end_tangent;
  way = straight(Vec2::Zero(), way.end);
  if (at(index).bulge == 0.0F) return way;
  const float half = cross(way.end_tangent, tangent);
  way.curvature = 2.0F * half / way.end.norm();
  way.start_tangent = 2.0F * way.end_tangent.dot(tangent) * way.end_tangent - tangent;
  way.end_tangent = tangent;
  return way;
}

/// Returns the height below which edges need no check. A rapid cuts nothing below its lower end.
/// For other motions, the height is so low that all edges are checked.
Coordinate OffsetChain::air_below(const Position& start, const Position& end, bool rapid) const {
  const std::size_t normal = path_.axes().normal;
  return rapid ? std::min(start[normal], end[normal])
               : Coordinate{-Coordinate::kFarthestNanometres};
}

/// Returns the index of an edge to which `way` comes too near; nothing if there is no such edge.
/// @param own index of the element to which `way` belongs: `way` is not compared with that element
/// @param air edges below this height are not compared: `way` is above them
std::optional<std::size_t> OffsetChain::too_near(const Curve& way,
                                                 const Place& origin,
                                                 std::size_t own,
                                                 Coordinate air) const {
  for (std::size_t i = 0; i < size(); ++i) {
    if (i == own || !path_.is_edge(i) || path_.is_below(i, air)) continue;
    if (come_nearer(way, path_.curve(i, origin), limit())) return i;
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
  const Coordinate air = air_below(path_.position(index), held.end, held.feed_mm_s <= 0.0F);
  for (const Kind kind : {Kind::kParallel, Kind::kJoin}) {
    if (!stretch({index, kind}).live) continue;
    const Curve way = driven(index, kind);
    const bool in = entry && kind == Kind::kParallel;
    if (in && way.end_tangent.dot(way.end) < -kHalfTurn * way.end.norm()) {
      return fault(Reason::kEntryTooShort, index, index);
    }
    const bool parallel = kind == Kind::kParallel && !entry;
    const auto near = too_near(way, path_.start_of(index), parallel ? index : size(), air);
    if (near) return fault(Reason::kTooNear, index, *near);
  }
  return std::nullopt;
}

std::optional<Fault> OffsetChain::leave(const Position& here, const Position& to, bool rapid) {
  const std::size_t last = path_.previous(size());
  const Name join{last, Kind::kJoin};
  // All coordinates below are relative to the end of the path.
  const Place origin = path_.start_of(size());
  const Vec2 tangent = path_.curve(last, origin).end_tangent;
  const Vec2 target = HeldPath::from(origin, path_.place_of(to));
  const float length = target.norm();
  Vec2 start = HeldPath::from(origin, path_.place_of(here));
  if (!at(last).waste && length > std::abs(distance_)) {
    exit_tangent_ = round(target / length, length, -1.0F);
    // If the exit turned by more than a third of a turn around the corner, it would cut into the
    // part.
    exit_rounds_ = cross(tangent, exit_tangent_) * distance_ > 0.0F &&
                   tangent.dot(exit_tangent_) >= kThirdOfATurn;
  }
  const Coordinate air = air_below(here, to, rapid);
  std::optional<std::size_t> near;
  if (exit_rounds_) {
    stretch(join).exists = true;
    add_raw(join, true);
    const Curve turn = raw(join, origin);
    start = turn.end;
    near = too_near(turn, origin, size(), air);
  }
  if (!near) near = too_near(straight(start, target), origin, size(), air);
  if (near) return fault(Reason::kTooNear, size(), *near);
  return std::nullopt;
}

}  // namespace cnc::compensation
