#include <array>
#include <cmath>

#include "planner/base/truncate.hpp"
#include "planner/base/units.hpp"
#include "planner/gcode/execution.hpp"
#include "planner/geometry/arc_elements.hpp"

namespace cnc::gcode {

namespace {

constexpr std::array<char, kLinearAxisCount> kOffsetLetters{'I', 'J', 'K'};

constexpr float to_mm(std::int64_t nanometres) { return Coordinate{nanometres}.mm(); }

}  // namespace

/// Handles G2 and G3 (RS274/NGC 3.5.3). Axes outside the plane move in proportion to the angle. An
/// arc with a centre but without an end in the plane is a full turn, as in LinuxCNC.
Refusal Execution::move_along_arc() {
  const PlaneAxes plane = axes_of(next_.modal.plane);
  if (block_.has('R') || !has_centre_word()) {
    if (!block_.has_axis_word()) return blame_motion(FaultDetail::kAxisWordsMissing);
    if (!block_.has(kAxisLetters[plane.first]) && !block_.has(kAxisLetters[plane.second])) {
      return blame_motion(FaultDetail::kNoAxisWordInPlane);
    }
  }
  Position target = next_.position;
  if (const auto fault = read_target(target)) return fault;
  std::uint16_t turns = 1;
  if (const auto fault = read_turns(turns)) return fault;
  const PlaneVector end = from_here(target);
  PlaneVector centre;
  if (const auto fault = find_centre(end, centre)) return fault;
  const CentreArc programmed{.start = next_.position,
                             .end = target,
                             .plane = next_.modal.plane,
                             .centre = {next_.position[plane.first] + Coordinate{centre.first},
                                        next_.position[plane.second] + Coordinate{centre.second}},
                             .clockwise = next_.modal.motion == MotionMode::kArcClockwise,
                             .turns = turns};
  // ArcElements determines the sweep both for this check and for the motion, so that they agree.
  const ArcElements elements{programmed};
  const float radius_mm = centre.length();
  if (elements.count() > 1) {
    if (const auto fault = check_sides(centre, radius_mm)) return fault;
  }

  Action& arc = actions_.append(ActionKind::kArc);
  arc.end = programmed.end;
  arc.plane = programmed.plane;
  arc.centre = programmed.centre;
  arc.clockwise = programmed.clockwise;
  arc.turns = programmed.turns;
  const float length = arc_length(arc, elements.sweep(), radius_mm);
  const bool inverse_time = next_.modal.feed_mode == FeedMode::kInverseTime;
  arc.feed = inverse_time ? length * inverse_time_ / kSecondsPerMinute : next_.modal.feed;
  next_.position = target;
  return check_duration(length, arc.feed);
}

Refusal Execution::read_turns(std::uint16_t& turns) {
  constexpr std::uint32_t kMax = 65'535;
  if (!block_.is_free('P')) return std::nullopt;
  std::uint32_t number = 0;
  if (const auto fault =
          take_index('P', ModalGroup::kMotion, kMax, FaultDetail::kTooLarge, number)) {
    return fault;
  }
  if (number == 0) return block_.blame(FaultDetail::kBelowOne, 'P');
  turns = static_cast<std::uint16_t>(number);
  return std::nullopt;
}

Refusal Execution::find_centre(PlaneVector end, PlaneVector& centre) {
  if (block_.has('R')) {
    if (const auto fault = centre_from_radius(end, centre)) return fault;
    return check_centre_in_range(centre);
  }
  if (const auto fault = read_centre(centre)) return fault;
  if (const auto fault = check_centre_in_range(centre)) return fault;
  return check_end_on_circle(end, centre);
}

/// Returns whether the line has an I, J or K along one of the plane's two axes.
bool Execution::has_centre_word() const {
  const PlaneAxes plane = axes_of(next_.modal.plane);
  return block_.has(kOffsetLetters[plane.first]) || block_.has(kOffsetLetters[plane.second]);
}

/// Reads the centre from I J K. With G91.1 it is relative to the start, and with G90.1 it is a
/// position. An offset along the third axis has no effect: post-processors write it, and Grbl
/// accepts it.
Refusal Execution::read_centre(PlaneVector& centre) {
  const PlaneAxes plane = axes_of(next_.modal.plane);
  const char first = kOffsetLetters[plane.first];
  const char second = kOffsetLetters[plane.second];
  if (!block_.has(first) && !block_.has(second)) return blame_motion(FaultDetail::kNoOffsetInPlane);
  const bool absolute = next_.modal.arc_distance == DistanceMode::kAbsolute;
  if (absolute && !(block_.has(first) && block_.has(second))) {
    Fault fault = blame_motion(FaultDetail::kCentreIncomplete);
    fault.letter = block_.has(first) ? second : first;
    return fault;
  }
  const auto offset = [&](char letter, std::size_t axis) {
    const Decimal* const number = block_.take(letter);
    Coordinate value = number != nullptr ? to_length(*number) : Coordinate{};
    if (absolute) value += work_offset(next_, places_, axis) - next_.position[axis];
    return value.nanometres();
  };
  centre = {offset(first, plane.first), offset(second, plane.second)};
  static_cast<void>(block_.take(kOffsetLetters[plane.normal]));
  if (centre.is_null()) return blame_centre(FaultDetail::kCentreIsStart, 0.0F, 0.0F);
  return std::nullopt;
}

Refusal Execution::centre_from_radius(PlaneVector end, PlaneVector& centre) {
  const Coordinate radius = to_length(*block_.take('R'));
  const float radius_mm = std::abs(radius.mm());
  if (end.is_null()) return blame_centre(FaultDetail::kEndIsStart, 0.0F, 0.0F);
  if (radius == Coordinate{}) return blame_centre(FaultDetail::kRadiusIsZero, 0.0F, 0.0F);
  if (!radius.in_range()) {
    return blame_centre(
        FaultDetail::kRadiusOutOfRange, radius_mm, to_mm(Coordinate::kFarthestNanometres));
  }
  const bool clockwise = next_.modal.motion == MotionMode::kArcClockwise;
  const CentreByRadius found = centre_by_radius(end, radius.nanometres(), clockwise);
  const float allowed = allowed_deviation(options_.arc, radius_mm);
  if (found.excess_mm > allowed) {
    return blame_centre(FaultDetail::kChordLongerThanDiameter, found.excess_mm, allowed);
  }
  centre = found.centre;
  // With a radius of one nanometre, the centre may be rounded to the start.
  if (centre.is_null()) return blame_centre(FaultDetail::kCentreIsStart, 0.0F, 0.0F);
  return std::nullopt;
}

Refusal Execution::check_centre_in_range(PlaneVector centre) const {
  const PlaneAxes plane = axes_of(next_.modal.plane);
  const float limit = to_mm(Coordinate::kFarthestNanometres);
  const Coordinate first = next_.position[plane.first] + Coordinate{centre.first};
  if (!first.in_range()) return blame_centre(FaultDetail::kCentreOutOfRange, first.mm(), limit);
  const Coordinate second = next_.position[plane.second] + Coordinate{centre.second};
  if (!second.in_range()) return blame_centre(FaultDetail::kCentreOutOfRange, second.mm(), limit);
  return std::nullopt;
}

/// Checks that the sides of the circle are within reach. This is necessary for an arc of more than
/// half a turn, which reaches the far side of the circle. A shorter arc stays near its chord.
Refusal Execution::check_sides(PlaneVector centre, float radius_mm) const {
  const PlaneAxes plane = axes_of(next_.modal.plane);
  const Coordinate radius{truncated(radius_mm * 1.0e6F)};
  const std::array<std::size_t, 2> axes{plane.first, plane.second};
  const std::array<std::int64_t, 2> offsets{centre.first, centre.second};
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const Coordinate middle = next_.position[axes[i]] + Coordinate{offsets[i]};
    for (const Coordinate side : {middle + radius, middle - radius}) {
      if (within_reach(axes[i], side)) continue;
      const Fault word = blame_centre(FaultDetail::kTargetOutOfRange, 0.0F, 0.0F);
      return out_of_reach(word, axes[i], side);
    }
  }
  return std::nullopt;
}

Refusal Execution::check_end_on_circle(PlaneVector end, PlaneVector centre) const {
  const float deviation = radius_deviation(end, centre);
  const float allowed = allowed_deviation(options_.arc, centre.length());
  if (deviation <= allowed) return std::nullopt;
  return blame_centre(FaultDetail::kEndOffCircle, deviation, allowed);
}

/// Returns the length along X Y Z in mm. @param sweep angle in radians, including full turns
float Execution::arc_length(const Action& arc, float sweep, float radius_mm) const {
  const std::size_t normal = axes_of(arc.plane).normal;
  const float rise = (arc.end[normal] - next_.position[normal]).mm();
  const float along = radius_mm * sweep;
  return std::sqrt(along * along + rise * rise);
}

PlaneVector Execution::from_here(const Position& target) const {
  const PlaneAxes plane = axes_of(next_.modal.plane);
  return {(target[plane.first] - next_.position[plane.first]).nanometres(),
          (target[plane.second] - next_.position[plane.second]).nanometres()};
}

/// Returns a fault at R or, without R, at the first offset of the plane that the line has.
Fault Execution::blame_centre(FaultDetail detail, float value_mm, float limit_mm) const {
  const PlaneAxes plane = axes_of(next_.modal.plane);
  const char first = kOffsetLetters[plane.first];
  const char offset = block_.has(first) ? first : kOffsetLetters[plane.second];
  Fault fault = block_.blame(detail, block_.has('R') ? 'R' : offset);
  fault.value = value_mm;
  fault.limit = limit_mm;
  return fault;
}

}  // namespace cnc::gcode
