#include "planner/pipeline/action_elements.hpp"

#include "planner/base/contract.hpp"
#include "planner/path/pixel_row.hpp"

namespace cnc {

using gcode::Action;
using gcode::ActionKind;

bool ActionElements::accepts(const Action& action) { return action.kind <= ActionKind::kSpline; }

void ActionElements::begin(const Action& action,
                           const Position& from,
                           float spline_tolerance_mm,
                           std::uint32_t min_parts,
                           bool rows) {
  CNC_ASSERT(accepts(action));
  here_ = from;
  feed_mm_s_ = action.kind == ActionKind::kRapid ? 0.0F : action.feed;
  taken_ = 0;
  if (action.kind == ActionKind::kArc) {
    curve_ = Curve::kArc;
    arc_.emplace(CentreArc{.start = from,
                           .end = action.end,
                           .plane = action.plane,
                           .centre = action.centre,
                           .clockwise = action.clockwise,
                           .turns = action.turns},
                 min_parts);
  } else if (action.kind == ActionKind::kSpline) {
    curve_ = Curve::kSpline;
    spline_.emplace(*action.spline, from, spline_tolerance_mm);
  } else {
    curve_ = Curve::kLine;
    line_ = {.from = from, .end = action.end, .powers = action.powers, .parts = min_parts};
    line_.is_row =
        rows && min_parts == 1 &&
        path::PixelRow::can_be_row({.start = from, .end = action.end}, action.powers.size());
  }
}

bool ActionElements::done() const {
  CNC_ASSERT(active());
  if (curve_ == Curve::kSpline) return spline_->done();
  return taken_ == (curve_ == Curve::kArc ? arc_->count() : line_.count());
}

bool ActionElements::work(std::uint32_t& points) {
  return curve_ != Curve::kSpline || spline_->work(points);
}

ActionPart ActionElements::next() {
  CNC_ASSERT(!done());
  ActionPart part{.feed_mm_s = feed_mm_s_, .continues = taken_ > 0, .index = taken_};
  if (curve_ == Curve::kSpline) {
    part.element = spline_->next();
  } else if (curve_ == Curve::kArc) {
    part.element = arc_->element(taken_);
  } else {
    part = next_of(line_);
  }
  here_ = part.element.end;
  ++taken_;
  return part;
}

/// Returns the next part of a line. The parts of a divided line are counted from 1, because 0 is
/// the index of an undivided line.
ActionPart ActionElements::next_of(const Line& line) const {
  ActionPart part{.element = {.start = here_, .end = line.end}, .feed_mm_s = feed_mm_s_};
  if (line.powers.empty() && line.parts == 1) return part;
  if (line.is_row) {
    part.row = line.powers;
    return part;
  }
  part.index = taken_ + 1;
  part.element.end = line.end_of(part.index);
  const bool new_power = taken_ % line.parts == 0;
  part.continues = !new_power;
  if (new_power && !line.powers.empty()) part.power_s = line.powers[taken_ / line.parts];
  return part;
}

std::uint32_t ActionElements::Line::count() const {
  if (is_row) return 1;
  return parts * (powers.empty() ? 1 : static_cast<std::uint32_t>(powers.size()));
}

/// Returns the end of part number `part`, counted from 1, rounded to the nanometre towards the
/// start.
Position ActionElements::Line::end_of(std::uint32_t part) const {
  Position place = end;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const std::int64_t distance = (end[axis] - from[axis]).nanometres();
    if (distance == 0) continue;
    place[axis] = from[axis] + Coordinate{distance * part / count()};
  }
  return place;
}

}  // namespace cnc
