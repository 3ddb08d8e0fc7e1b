#include "planner/geometry/arc_elements.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/contract.hpp"
#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc.hpp"

namespace cnc {
namespace {

/// If an arc turns by at most kFullCircle radians, and its end is within kRoundedEndMm of its
/// start, it is a full circle whose end was rounded.
constexpr float kFullCircle = 5.0e-7F;
constexpr float kRoundedEndMm = 1.0e-3F;

/// The error of atan2 may make an arc of half a turn too long by this share of π.
constexpr float kHalfTurnSlack = 1.5e-7F;

float length(float x, float y) { return std::sqrt(x * x + y * y); }

}  // namespace

ArcElements::ArcElements(const CentreArc& arc, std::uint32_t min_count) noexcept
    : arc_{arc}, axes_{axes_of(arc.plane)} {
  const float x0 = (arc.start[axes_.first] - arc.centre[0]).mm();
  const float y0 = (arc.start[axes_.second] - arc.centre[1]).mm();
  const float x1 = (arc.end[axes_.first] - arc.centre[0]).mm();
  const float y1 = (arc.end[axes_.second] - arc.centre[1]).mm();
  const float dx = (arc.end[axes_.first] - arc.start[axes_.first]).mm();
  const float dy = (arc.end[axes_.second] - arc.start[axes_.second]).mm();
  start_radius_ = length(x0, y0);
  end_radius_ = length(x1, y1);
  CNC_ASSERT(start_radius_ > 0.0F);
  start_cosine_ = x0 / start_radius_;
  start_sine_ = y0 / start_radius_;

  // Computed with the difference of end and start, the cross product loses no digits for short
  // arcs.
  const float left_turn = atan2_f(x0 * dy - y0 * dx, x0 * x1 + y0 * y1);
  const float turn = arc.clockwise ? -left_turn : left_turn;
  const bool is_full = turn <= kFullCircle && (turn <= 0.0F || length(dx, dy) <= kRoundedEndMm);
  partial_turn_ = is_full ? turn + kTwoPi : turn;
  sweep_ = partial_turn_ + kTwoPi * static_cast<float>(arc.turns - 1);
  count_ = static_cast<std::uint32_t>(std::ceil(sweep_ / kPi - kHalfTurnSlack));
  count_ = std::max({count_, min_count, std::uint32_t{1}});
}

Position ArcElements::division(std::uint32_t index) const {
  if (index == 0) return arc_.start;
  if (index >= count_) return arc_.end;
  Position place;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const std::int64_t travel = (arc_.end[axis] - arc_.start[axis]).nanometres();
    place[axis] = arc_.start[axis] + Coordinate{travel * index / count_};
  }
  const float part = static_cast<float>(index) / static_cast<float>(count_);
  const float radius = start_radius_ + (end_radius_ - start_radius_) * part;
  // Each whole turn advances this point by the share index / count_ of a turn. Of the sum, only the
  // fraction of a turn matters. It is computed in integers, so that even a thousand turns lose no
  // digits.
  const std::uint64_t whole_turns = arc_.turns - 1U;
  const auto turned_share = static_cast<float>(whole_turns * index % count_);
  const float angle = partial_turn_ * part + kTwoPi * (turned_share / static_cast<float>(count_));
  const SinCos turned = sin_cos(arc_.clockwise ? -angle : angle);
  const float cosine = start_cosine_ * turned.cosine - start_sine_ * turned.sine;
  const float sine = start_sine_ * turned.cosine + start_cosine_ * turned.sine;
  place[axes_.first] = arc_.centre[0] + from_mm(radius * cosine);
  place[axes_.second] = arc_.centre[1] + from_mm(radius * sine);
  return place;
}

/// Returns the bulge of an element. Let c be half of the chord, and m the height of the centre
/// above the chord, on the side to which the arc turns. The radius is R = hypot(c, m), and
/// tan(sweep / 4) = c / (R + m).
float ArcElements::bulge_of(const PathElement& element) const {
  const float dx = (element.end[axes_.first] - element.start[axes_.first]).mm();
  const float dy = (element.end[axes_.second] - element.start[axes_.second]).mm();
  const float chord = length(dx, dy);
  if (chord <= 0.0F) return 0.0F;
  const float cx = (arc_.centre[0] - element.start[axes_.first]).mm() - 0.5F * dx;
  const float cy = (arc_.centre[1] - element.start[axes_.second]).mm() - 0.5F * dy;
  const float to_left = (dx * cy - dy * cx) / chord;
  const float height = arc_.clockwise ? -to_left : to_left;
  const float half = 0.5F * chord;
  // On a circle of a few micrometres, rounding may place the two ends more than half a turn apart,
  // so the bulge is limited.
  const float bulge = std::min(half / (length(half, height) + height), Arc::kLargestBulge);
  return arc_.clockwise ? -bulge : bulge;
}

PathElement ArcElements::element(std::uint32_t index) const {
  CNC_ASSERT(index < count_);
  PathElement element{
      .start = division(index), .end = division(index + 1), .plane = arc_.plane, .bulge = 0.0F};
  element.bulge = bulge_of(element);
  return element;
}

}  // namespace cnc
