#include "host-sim/machine/five_axis_model.hpp"

#include <numbers>

namespace sim {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr std::size_t kTurning = 5;

Isometry3d about(const Vector3d& point, const Vector3d& axis, double degrees) {
  constexpr double kDegreeInRadians = std::numbers::pi / 180.0;
  return Isometry3d{Translation3d{point} * AngleAxisd{degrees * kDegreeInRadians, axis} *
                    Translation3d{-point}};
}

Vector3d point_of(const cnc::Settings& settings, std::uint16_t first) {
  return {settings.get(first, 0), settings.get(first, 1), settings.get(first, 2)};
}

}  // namespace

FiveAxisModel::FiveAxisModel(const cnc::Settings& settings, double tool_length_mm)
    : tilt_point_{point_of(settings, cnc::setting::kTiltPoint)},
      turn_point_{point_of(settings, cnc::setting::kTurnPoint)},
      tool_length_mm_{tool_length_mm} {
  const int chosen = static_cast<int>(settings.get(cnc::setting::kRotaryAxes));
  if (chosen != 0) kind_ = static_cast<Kind>((chosen + 1) / 2);
  tilting_ = chosen % 2 == 0 ? 4 : 3;
  const int reversed = static_cast<int>(settings.get(cnc::setting::kRotaryReversed));
  tilt_reversed_ = reversed % 2 == 1;
  turn_reversed_ = reversed / 2 == 1;
}

Isometry3d FiveAxisModel::tilt(double degrees) const {
  const Vector3d axis = tilting_ == 3 ? Vector3d{Vector3d::UnitX()} : Vector3d{Vector3d::UnitY()};
  return about(tilt_point_, axis, tilt_reversed_ ? -degrees : degrees);
}

Isometry3d FiveAxisModel::turn(double degrees) const {
  return about(turn_point_, Vector3d::UnitZ(), turn_reversed_ ? -degrees : degrees);
}

// Relative to the part, the tool turns in the opposite direction to a table that carries the part.
// The pivot points of a head move along with the axes X Y Z that carry the head.
FiveAxisModel::Turned FiveAxisModel::turned_to(const Point& axes) const {
  const double tilted = axes[tilting_];
  const double turned = axes[kTurning];
  switch (kind_) {
    case Kind::kTables:
      return {.part = tilt(-tilted) * turn(-turned)};
    case Kind::kHeads:
      return {.head = turn(turned) * tilt(tilted)};
    case Kind::kHeadAndTable:
      return {.part = turn(-turned), .head = tilt(tilted)};
    case Kind::kNone:
      break;
  }
  return {};
}

ToolPose FiveAxisModel::tool_at(const Point& axes) const {
  const Turned turned = turned_to(axes);
  const Vector3d carried{axes[0], axes[1], axes[2]};
  const Isometry3d from_part = turned.part.inverse() * Translation3d{carried} * turned.head;
  return {.tip = from_part * tool() - tool(), .axis = from_part.linear() * Vector3d::UnitZ()};
}

Point FiveAxisModel::program_for(const Point& axes) const {
  const Vector3d tip = tool_at(axes).tip;
  Point place = axes;
  for (std::size_t i = 0; i < 3; ++i) place[i] = tip[static_cast<Eigen::Index>(i)];
  return place;
}

Point FiveAxisModel::axes_for(const Point& program) const {
  const Turned turned = turned_to(program);
  const Vector3d tip{program[0], program[1], program[2]};
  const Vector3d carried = turned.part * (tip + tool()) - turned.head * tool();
  Point axes = program;
  for (std::size_t i = 0; i < 3; ++i) axes[i] = carried[static_cast<Eigen::Index>(i)];
  return axes;
}

}  // namespace sim
