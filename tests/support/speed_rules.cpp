#include "tests/support/speed_rules.hpp"

#include <cmath>

namespace sim {

PlaceBarrier::PlaceBarrier(double y, double first, double second)
    : y_{y}, first_{first}, second_{second}, speed_{std::cbrt(y)}, kept_{y > 0.0} {}

/// Adds −log(room), where `room` is the margin of a rule and `slope` its gradient.
void PlaceBarrier::add_log(double room, const Slope& slope) {
  if (!(room > 0.0)) kept_ = false;
  if (!kept_) return;
  value_ -= std::log(room);
  const double inverse = 1.0 / room;
  for (std::size_t i = 0; i < 3; ++i) {
    gradient_[i] -= slope[i] * inverse;
    for (std::size_t k = i; k < 3; ++k) {
      hessian_[i][k] += slope[i] * slope[k] * inverse * inverse;
    }
  }
}

void PlaceBarrier::keep_below(double cap) { add_log(cap - y_, {-1.0, 0.0, 0.0}); }

void PlaceBarrier::keep_acceleration(const PlaceRules& rules) {
  for (std::size_t i = 0; i < rules.count; ++i) {
    const AxisRule& axis = rules.axes[i];
    const double slope = axis.acceleration / (speed_ * speed_);  // Derivative of 3 A y^⅓.
    const double used = axis.tangent * first_ + 3.0 * axis.bend * y_;
    for (const double sign : {1.0, -1.0}) {
      const double room = 3.0 * axis.acceleration * speed_ - sign * used;
      add_log(room, {slope - sign * 3.0 * axis.bend, -sign * axis.tangent, 0.0});
      hessian_[0][0] += 2.0 / 3.0 * slope / y_ / room;
    }
  }
}

void PlaceBarrier::jerk_from_below(const AxisRule& axis, double sign) {
  const double t = sign * axis.tangent;
  const double relief = first_ * first_ / (9.0 * y_);
  const double room =
      t * (second_ / 3.0 - relief) + sign * (axis.bend * first_ + axis.twist * y_) + axis.jerk;
  const double lean = first_ / y_;
  add_log(room,
          {t * relief / y_ + sign * axis.twist, -2.0 / 9.0 * t * lean + sign * axis.bend, t / 3.0});
  // Second derivative of t y′²/9y, along (1, −y′/y) in (y′, y).
  const double curve = 2.0 / 9.0 * t / y_ / room;
  hessian_[1][1] += curve;
  hessian_[0][1] -= curve * lean;
  hessian_[0][0] += curve * lean * lean;
}

void PlaceBarrier::jerk_from_above(const AxisRule& axis, double sign, const JerkRelief& relief) {
  const double t = sign * axis.tangent;
  const double room = axis.jerk - t * second_ / 3.0 - sign * (axis.bend * first_ + axis.twist * y_);
  const Slope slope{-sign * axis.twist, -sign * axis.bend, -t / 3.0};
  if (relief.exact) {
    // The Hessian omits the curvature of a²/v itself, which is concave here.
    const double exact = first_ * first_ / (9.0 * y_);
    add_log(room + t * exact,
            {slope[0] - t * exact / y_, slope[1] + 2.0 / 9.0 * t * first_ / y_, slope[2]});
    return;
  }
  add_log(room + t * relief.most, slope);
  if (relief.slope <= 0.0) return;
  add_log(room + t * (relief.offset - relief.slope * y_),
          {slope[0] - t * relief.slope, slope[1], slope[2]});
}

void PlaceBarrier::keep_jerk(const PlaceRules& rules, const JerkRelief& relief) {
  for (std::size_t i = 0; i < rules.count; ++i) {
    const AxisRule& axis = rules.axes[i];
    if (std::isinf(axis.jerk)) continue;
    const double sign = axis.tangent < 0.0 ? -1.0 : 1.0;
    jerk_from_below(axis, sign);
    jerk_from_above(axis, sign, relief);
  }
}

void PlaceBarrier::keep_ramp(double most) {
  if (!std::isfinite(most)) return;
  const double slope = 1.5 * std::sqrt(most / y_);
  for (const double sign : {1.0, -1.0}) {
    const double room = 2.0 * slope * y_ - sign * first_;
    add_log(room, {slope, -sign, 0.0});
    hessian_[0][0] += 0.5 * slope / y_ / room;
  }
}

void PlaceBarrier::add_time(double weight) {
  const double time = weight / speed_;
  value_ += time;
  gradient_[0] -= time / (3.0 * y_);
  hessian_[0][0] += 4.0 / 9.0 * time / (y_ * y_);
}

}  // namespace sim
