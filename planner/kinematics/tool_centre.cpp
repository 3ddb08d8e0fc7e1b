#include "planner/kinematics/tool_centre.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/truncate.hpp"

namespace cnc::kinematics {
namespace {

constexpr std::size_t kTurning = index_of(Axis::kC);
constexpr std::size_t kTurnsAbout = 2;
constexpr float kRadiansPerDegree = kPi / 180.0F;

/// Returns a rotary position in degrees, without its full turns: between −180 and 180. Single
/// precision resolves angles well only in that range.
float within_half_turn(Coordinate place) {
  constexpr std::int64_t kTurn = 360'000'000;
  std::int64_t rest = place.nanometres() % kTurn;
  if (rest > kTurn / 2) rest -= kTurn;
  if (rest < -kTurn / 2) rest += kTurn;
  return Coordinate{rest}.mm();
}

/// Returns the difference between a position and its nearest whole step, mm.
float part_of_step(StepPosition place, std::int32_t nearest, const AxisScale& scale) {
  const auto part = static_cast<float>(place.q32() - StepPosition::whole(nearest).q32());
  return part * StepPosition::kStepsPerUnit / scale.steps_per_mm();
}

SinCos angle_of(float degrees, bool reversed) {
  const SinCos angle = sin_cos(degrees * kRadiansPerDegree);
  return reversed ? opposite(angle) : angle;
}

Eigen::Index index(std::size_t axis) { return static_cast<Eigen::Index>(axis); }

}  // namespace

ToolCentre::ToolCentre(const RotaryMachine& machine, Coordinate tool_length)
    : machine_{machine}, tool_length_{tool_length} {
  const Vec3 tool{0.0F, 0.0F, tool_length.mm()};
  for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
    centre_[axis] = from_mm(machine.turn_point[index(axis)]);
  }
  centre_[index_of(Axis::kZ)] += tool_length;
  tilt_from_turn_ = machine.tilt_point - machine.turn_point;
  tip_from_tilt_ = -machine.tilt_point - tool;
}

bool ToolCentre::has_turning_table() const {
  return machine_.kind == RotaryKind::kTables || machine_.kind == RotaryKind::kHeadAndTable;
}

ToolCentre::Pose ToolCentre::pose_of(const Position& place) const {
  Pose pose;
  for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
    pose.place[index(axis)] = (place[axis] - centre_[axis]).mm();
  }
  pose.tilt = angle_of(within_half_turn(place[tilting_axis()]), machine_.tilt_reversed);
  pose.turn = angle_of(within_half_turn(place[kTurning]), machine_.turn_reversed);
  return pose;
}

ToolCentre::Pose ToolCentre::pose_of(const AxisArray<StepPosition>& place,
                                     const AxisArray<AxisScale>& scale) const {
  Position nearest;
  AxisArray<float> part{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const std::int32_t step = place[axis].nearest_step();
    nearest[axis] = scale[axis].place_of(step);
    part[axis] = part_of_step(place[axis], step, scale[axis]);
  }
  Pose pose;
  for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
    pose.place[index(axis)] = (nearest[axis] - centre_[axis]).mm() + part[axis];
  }
  const std::size_t tilting = tilting_axis();
  pose.tilt = angle_of(within_half_turn(nearest[tilting]) + part[tilting], machine_.tilt_reversed);
  pose.turn =
      angle_of(within_half_turn(nearest[kTurning]) + part[kTurning], machine_.turn_reversed);
  return pose;
}

/// Returns a jet after the rotations of the tables. Tables turn the part in the opposite direction
/// to the rotation of the tool relative to the part.
PlaceJet ToolCentre::on_tables(const PlaceJet& from_centre,
                               const AngleJet& tilt,
                               const AngleJet& turn) const {
  if (!has_turning_table()) return from_centre;
  PlaceJet jet = turned(kTurnsAbout, opposite(turn), from_centre);
  if (!has_tilting_table()) return jet;
  jet.place -= tilt_from_turn_;
  jet = turned(tilts_about(), opposite(tilt), jet);
  jet.place += tilt_from_turn_;
  return jet;
}

/// Returns the displacement of the tip that the rotations of the head cause.
PlaceJet ToolCentre::of_head(const AngleJet& tilt, const AngleJet& turn) const {
  if (has_tilting_table()) return {};
  PlaceJet jet = turned(tilts_about(), tilt, PlaceJet{.place = tip_from_tilt_});
  if (machine_.kind == RotaryKind::kHeadAndTable) {
    jet.place -= tip_from_tilt_;
    return jet;
  }
  jet.place += tilt_from_turn_;
  jet = turned(kTurnsAbout, turn, jet);
  jet.place -= tilt_from_turn_ + tip_from_tilt_;
  return jet;
}

Vec3 ToolCentre::shift(const Pose& program) const {
  const AngleJet tilt{program.tilt};
  const AngleJet turn{program.turn};
  const PlaceJet table = on_tables({.place = program.place}, tilt, turn);
  return table.place - program.place - of_head(tilt, turn).place;
}

Vec3 ToolCentre::shift_back(const Pose& axes) const {
  const Vec3 head = of_head({axes.tilt}, {axes.turn}).place;
  Vec3 place = axes.place + head;
  if (has_tilting_table()) {
    place = turned(tilts_about(), axes.tilt, Vec3{place - tilt_from_turn_}) + tilt_from_turn_;
  }
  if (has_turning_table()) place = turned(kTurnsAbout, axes.turn, place);
  return place - axes.place;
}

Position ToolCentre::axes_for(const Position& program) const {
  if (!active()) return program;
  const Vec3 way = shift(pose_of(program));
  Position axes = program;
  for (std::size_t i = 0; i < kLinearAxisCount; ++i) axes[i] += from_mm(way[index(i)]);
  return axes;
}

Position ToolCentre::program_for(const Position& axes) const {
  if (!active()) return axes;
  const Vec3 way = shift_back(pose_of(axes));
  Position program = axes;
  for (std::size_t i = 0; i < kLinearAxisCount; ++i) program[i] += from_mm(way[index(i)]);
  return program;
}

AxisArray<StepPosition> ToolCentre::axes_for(const AxisArray<StepPosition>& program,
                                             const AxisArray<AxisScale>& scale) const {
  constexpr float kQ16 = 65'536.0F;
  AxisArray<StepPosition> axes = program;
  if (!active()) return axes;
  const Vec3 way = shift(pose_of(program, scale));
  for (std::size_t i = 0; i < kLinearAxisCount; ++i) {
    const float steps = way[index(i)] * scale[i].steps_per_mm();
    axes[i] = StepPosition{program[i].q32() + truncated(steps * kQ16) * 65'536};
  }
  return axes;
}

PlaceJet ToolCentre::axes_along(const Way& way) const {
  const Pose pose = pose_of(way.place);
  const auto angle = [&way](const SinCos& at, std::size_t axis, bool reversed) {
    const float unit = reversed ? -kRadiansPerDegree : kRadiansPerDegree;
    return AngleJet{at, unit * way.first[axis], unit * way.second[axis]};
  };
  const AngleJet tilt = angle(pose.tilt, tilting_axis(), machine_.tilt_reversed);
  const AngleJet turn = angle(pose.turn, kTurning, machine_.turn_reversed);
  PlaceJet jet = on_tables({.place = pose.place,
                            .first = {way.first[0], way.first[1], way.first[2]},
                            .second = {way.second[0], way.second[1], way.second[2]}},
                           tilt,
                           turn);
  const PlaceJet head = of_head(tilt, turn);
  jet.place -= head.place;
  jet.first -= head.first;
  jet.second -= head.second;
  return jet;
}

float ToolCentre::lever(const Position& place, float reach_mm) const {
  const float head = tip_from_tilt_.norm() + tilt_from_turn_.norm();
  if (machine_.kind == RotaryKind::kHeads) return head;
  float lever = reach_mm + 2.0F * tilt_from_turn_.norm();
  for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
    lever += std::abs((place[axis] - centre_[axis]).mm());
  }
  return machine_.kind == RotaryKind::kTables ? lever : lever + head;
}

// Bounds the third derivative of R(φ(s)) · u(s) with respect to the length s of the path. Here u is
// the vector from a rotary axis to the tip, and R is its rotation by the angle φ. The magnitude of
// the first derivative of φ is at most `rate`. On a circle of the given curvature, the magnitudes
// of the second and third derivatives of φ are at most rate · curvature and rate · curvature².
float ToolCentre::third_derivative(float lever_mm, float rate, float curvature) {
  const float second = square(rate) + rate * curvature;
  const float third = rate * (square(rate) + 3.0F * rate * curvature + square(curvature));
  return third * lever_mm + 3.0F * second + 3.0F * rate * curvature + square(curvature);
}

std::uint32_t ToolCentre::parts_of(const Position& from, const Position& end) const {
  // Greatest rotation of a rotary axis on one part of the path, in units of 1e-6 degrees.
  constexpr std::int64_t kMax = 4'000'000;
  if (!active()) return 1;
  const auto turn = [&](std::size_t axis) {
    const std::int64_t way = (end[axis] - from[axis]).nanometres();
    return way < 0 ? -way : way;
  };
  const std::int64_t way = std::max(turn(tilting_axis()), turn(kTurning));
  return static_cast<std::uint32_t>(std::max<std::int64_t>(1, (way + kMax - 1) / kMax));
}

Vec3 ToolCentre::direction(const Position& program) const {
  const Pose pose = pose_of(program);
  return turned(kTurnsAbout, pose.turn, turned(tilts_about(), pose.tilt, Vec3{0.0F, 0.0F, 1.0F}));
}

}  // namespace cnc::kinematics
