#include "planner/base/units.hpp"
#include "planner/gcode/execution.hpp"
#include "planner/geometry/spline_length.hpp"

namespace cnc::gcode {

namespace {

PlanePlace sum(const PlanePlace& a, const PlanePlace& b) { return {a.x + b.x, a.y + b.y}; }

/// Distance by which the arcs that replace a spline may leave the hull of its control points, nm.
/// The spline itself stays inside the hull, but the arcs follow it only within a tolerance.
constexpr Coordinate kBesideHull{100'000};

}  // namespace

/// Handles G5, G5.1, G5.2 and G5.3 as LinuxCNC defines them: in the plane of X and Y, without
/// motion of other axes.
Refusal Execution::move_along_spline(MotionMode mode) {
  if (mode == MotionMode::kNurbsEnd) return end_nurbs();
  if (next_.modal.plane != Plane::kXY) return blame_motion(FaultDetail::kSplineNeedsG17);
  return mode == MotionMode::kCubicSpline ? move_along_cubic() : move_along_quadratic();
}

/// Handles G5. I and J give the vector from the start to the first control point. P and Q give the
/// vector from the end to the second control point. Without I and J, the curve continues in the
/// direction in which the previous G5 ended.
Refusal Execution::move_along_cubic() {
  Position target = next_.position;
  if (const auto fault = read_spline_end(target)) return fault;
  PlanePlace first;
  if (const auto fault = read_first_arm(first)) return fault;
  if (!block_.has('P')) return missing_in_motion('P');
  if (!block_.has('Q')) return missing_in_motion('Q');
  const PlanePlace arm = take_arm('P', 'Q');
  const PlaneVector end = from_here(target);
  const PlanePlace last{end.first, end.second};
  const PlanePlace second = sum(last, arm);
  if (const auto fault = check_control_point(first, 'I')) return fault;
  if (const auto fault = check_control_point(second, 'P')) return fault;
  Spline& spline = store_.spline;
  spline.clear();
  spline.set_order(4);
  for (const PlanePlace& place : {PlanePlace{}, first, second, last}) spline.append({place});
  if (const auto fault = append_spline(target)) return fault;
  next_.cubic_exit = {.known = true,
                      .place = {target[0], target[1]},
                      .arm = {Coordinate{-arm.x}, Coordinate{-arm.y}}};
  return std::nullopt;
}

/// Handles G5.1. I and J give the vector from the start to the only control point between the ends.
Refusal Execution::move_along_quadratic() {
  Position target = next_.position;
  if (const auto fault = read_spline_end(target)) return fault;
  if (!block_.has('I') && !block_.has('J')) return blame_motion(FaultDetail::kArmMissing);
  const PlanePlace middle = take_arm('I', 'J');
  if (const auto fault = check_control_point(middle, block_.has('I') ? 'I' : 'J')) return fault;
  const PlaneVector end = from_here(target);
  Spline& spline = store_.spline;
  spline.clear();
  spline.set_order(3);
  for (const PlanePlace& place : {PlanePlace{}, middle, PlanePlace{end.first, end.second}}) {
    spline.append({place});
  }
  return append_spline(target);
}

Refusal Execution::read_spline_end(Position& target) {
  for (std::size_t axis = 2; axis < kAxisCount; ++axis) {
    const char letter = kAxisLetters[axis];
    if (block_.has(letter)) return block_.blame(FaultDetail::kAxisNotInSpline, letter);
  }
  if (!block_.has_axis_word()) return blame_motion(FaultDetail::kAxisWordsMissing);
  return read_target(target);
}

Refusal Execution::read_first_arm(PlanePlace& arm) {
  if (block_.has('I') != block_.has('J')) return missing_in_motion(block_.has('I') ? 'J' : 'I');
  if (block_.has('I')) {
    arm = take_arm('I', 'J');
    return std::nullopt;
  }
  const CubicExit& exit = context_.cubic_exit;
  const bool leads_here = exit.known && context_.modal.motion == MotionMode::kCubicSpline &&
                          exit.place[0] == next_.position[0] && exit.place[1] == next_.position[1];
  if (!leads_here) return blame_motion(FaultDetail::kArmMissing);
  arm = {exit.arm[0].nanometres(), exit.arm[1].nanometres()};
  return std::nullopt;
}

/// Returns the vector whose components are the words `first` and `second`. A word that is not in
/// the line counts as 0.
PlanePlace Execution::take_arm(char first, char second) {
  const auto length = [&](char letter) {
    const Decimal* const number = block_.take(letter);
    return number != nullptr ? to_length(*number).nanometres() : 0;
  };
  return {length(first), length(second)};
}

/// Checks that a control point is within reach of the motors. If all control points are, the curve
/// is within reach, too, because it stays inside the hull of its control points.
Refusal Execution::check_control_point(const PlanePlace& place, char letter) const {
  const std::array<Coordinate, 2> offset{Coordinate{place.x}, Coordinate{place.y}};
  for (std::size_t axis = 0; axis < offset.size(); ++axis) {
    const Coordinate reach = options_.reach[axis] - kBesideHull;
    const Coordinate at = next_.position[axis] + offset[axis];
    if (at >= -reach && at <= reach) continue;
    Fault fault = block_.has(letter) ? block_.blame(FaultDetail::kControlPointOutOfRange, letter)
                                     : blame_motion(FaultDetail::kControlPointOutOfRange);
    fault.value = at.mm();
    fault.limit = reach.mm();
    return fault;
  }
  return std::nullopt;
}

Refusal Execution::append_spline(const Position& end) {
  Action& action = actions_.append(ActionKind::kSpline);
  action.end = end;
  action.spline = &store_.spline;
  action.feed = spline_speed();
  next_.position = end;
  constexpr float kSlow = 1.0F;  // mm/s. A faster spline never takes too long.
  if (action.feed > kSlow) return std::nullopt;
  return check_duration(length_of(store_.spline), action.feed);
}

float Execution::spline_speed() const {
  if (next_.modal.feed_mode != FeedMode::kInverseTime) return next_.modal.feed;
  return length_of(store_.spline) * inverse_time_ / kSecondsPerMinute;
}

Fault Execution::missing_in_motion(char letter) const {
  Fault fault = blame_motion(FaultDetail::kWordMissing);
  fault.letter = letter;
  return fault;
}

}  // namespace cnc::gcode
