#include "host-sim/wall/path/rotary_words.hpp"

#include <cmath>
#include <numbers>

#include "planner/base/wide_scalar_math.hpp"

namespace sim::wall {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Returns an angle, changed by a multiple of 360 degrees to the value nearest to `last`.
double unwrapped(double angle, double last) {
  return angle - 360.0 * std::round((angle - last) / 360.0);
}

double square_distance(const RotaryWords& from, const RotaryWords& to) {
  const double tilt = to.tilt - from.tilt;
  const double turn = to.turn - from.turn;
  return tilt * tilt + turn * turn;
}

}  // namespace

Eigen::Vector3d axis_of(RotaryAxes axes, const RotaryWords& words) {
  const cnc::WideSinCos tilt = cnc::sin_cos(words.tilt * kDegree);
  const cnc::WideSinCos turn = cnc::sin_cos(std::remainder(words.turn, 360.0) * kDegree);
  if (axes == RotaryAxes::kAC) {
    return {turn.sine * tilt.sine, -turn.cosine * tilt.sine, tilt.cosine};
  }
  return {turn.cosine * tilt.sine, turn.sine * tilt.sine, tilt.cosine};
}

RotaryWords first_words_of(RotaryAxes axes, const Eigen::Vector3d& axis) {
  const double tilt = cnc::wide_atan2(std::hypot(axis.x(), axis.y()), axis.z()) / kDegree;
  if (tilt < kNoTiltDeg) return {};
  const double turn = axes == RotaryAxes::kAC ? cnc::wide_atan2(axis.x(), -axis.y())
                                              : cnc::wide_atan2(axis.y(), axis.x());
  return {tilt, turn / kDegree};
}

RotaryWords words_of(RotaryAxes axes, const Eigen::Vector3d& axis, const RotaryWords& last) {
  const RotaryWords first = first_words_of(axes, axis);
  if (first.tilt == 0.0) return {0.0, last.turn};
  const RotaryWords near{first.tilt, unwrapped(first.turn, last.turn)};
  const RotaryWords other{-first.tilt, unwrapped(first.turn + 180.0, last.turn)};
  return square_distance(last, other) < square_distance(last, near) ? other : near;
}

}  // namespace sim::wall
