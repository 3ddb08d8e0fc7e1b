#include "planner/pipeline/action_elements.hpp"

#include "planner/base/contract.hpp"

namespace cnc {

using gcode::Action;
using gcode::ActionKind;

bool ActionElements::accepts(const Action& action) { return action.kind <= ActionKind::kSpline; }

void ActionElements::begin(const Action& action, const Position& from, float spline_tolerance_mm) {
  CNC_ASSERT(accepts(action));
  here_ = from;
  feed_mm_s_ = action.kind == ActionKind::kRapid ? 0.0F : action.feed;
  taken_ = 0;
  if (action.kind == ActionKind::kArc) {
    curve_.emplace<ArcElements>(CentreArc{.start = from,
                                          .end = action.end,
                                          .plane = action.plane,
                                          .centre = action.centre,
                                          .clockwise = action.clockwise,
                                          .turns = action.turns});
  } else if (action.kind == ActionKind::kSpline) {
    curve_.emplace<ArcFit>(*action.spline, from, spline_tolerance_mm);
  } else {
    curve_ = Line{.from = from, .end = action.end, .powers = action.powers};
  }
}

bool ActionElements::done() const {
  if (const auto* const fit = std::get_if<ArcFit>(&curve_)) return fit->done();
  if (const auto* const arc = std::get_if<ArcElements>(&curve_)) return taken_ == arc->count();
  const auto* const line = std::get_if<Line>(&curve_);
  CNC_ASSERT(line != nullptr);
  return taken_ == line->count();
}

bool ActionElements::work(std::uint32_t& points) {
  auto* const fit = std::get_if<ArcFit>(&curve_);
  return fit == nullptr || fit->work(points);
}

ActionPart ActionElements::next() {
  CNC_ASSERT(!done());
  ActionPart part{.feed_mm_s = feed_mm_s_, .continues = taken_ > 0, .index = taken_};
  if (auto* const fit = std::get_if<ArcFit>(&curve_)) {
    part.element = fit->next();
  } else if (const auto* const arc = std::get_if<ArcElements>(&curve_)) {
    part.element = arc->element(taken_);
  } else if (const auto* const line = std::get_if<Line>(&curve_)) {
    part = next_of(*line);
  }
  here_ = part.element.end;
  ++taken_;
  return part;
}

/// Parts of a line are counted from 1: the line itself would be part 0.
ActionPart ActionElements::next_of(const Line& line) const {
  ActionPart part{.element = {.start = here_, .end = line.end}, .feed_mm_s = feed_mm_s_};
  if (line.powers.empty()) return part;
  part.index = taken_ + 1;
  part.element.end = line.end_of(part.index);
  part.power_s = line.powers[taken_];
  return part;
}

std::uint32_t ActionElements::Line::count() const {
  return powers.empty() ? 1 : static_cast<std::uint32_t>(powers.size());
}

/// Returns the end of a part, counted from 1, rounded to the nanometre towards the start.
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
