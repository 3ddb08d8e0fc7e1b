#pragma once

#include <array>

#include "host-sim/measure/curve.hpp"

namespace sim {

/// Rule of one axis, or of all axes that move straight, at a point of the path.
struct AxisRule {
  double tangent = 0.0;       ///< Component of the tangent, t.
  double bend = 0.0;          ///< Derivative of t by length, t′, 1/mm.
  double twist = 0.0;         ///< Second derivative of t by length, t″, 1/mm².
  double acceleration = 0.0;  ///< Greatest acceleration, mm/s².
  double jerk = 0.0;          ///< Greatest jerk, mm/s³.
};

/// Rules of all axes: one for each axis that takes part in an arc (two in a coordinate plane), and
/// one for all axes that move straight.
struct PlaceRules {
  std::array<AxisRule, cnc::kAxisCount + 1> axes{};
  std::size_t count = 0;
};

/// The value for a²/v in the rule that limits an axis's jerk from above.
struct JerkRelief {
  bool exact = true;    ///< Uses a²/v itself, else the lesser of the two upper bounds below.
  double most = 0.0;    ///< First bound: a constant, mm/s³.
  double offset = 0.0;  ///< Second bound: offset − slope · y.
  double slope = 0.0;
};

/// The barrier of the rules at one point, as a function of y = v³ and its derivatives y′ = 3 v a
/// and y″ by length. It has a gradient and a positive semidefinite Hessian.
///
/// As functions of y the motion rules are (nearly) convex, which they are not in v or v²:
///   axis acceleration  |t y′ + 3 t′ y| ≤ 3 A y^⅓                        (convex)
///   axis jerk          |t (y″/3 − y′²/9y) + t′ y′ + t″ y| ≤ J
/// The term y′²/9y = a²/v is convex. So the side of the jerk rule that limits how fast t j falls is
/// convex. The other side is not, and JerkRelief bounds it.
class PlaceBarrier {
 public:
  PlaceBarrier(double y, double first, double second);

  void keep_below(double cap);
  void keep_acceleration(const PlaceRules& rules);
  void keep_jerk(const PlaceRules& rules, const JerkRelief& relief);
  /// Adds the rule a²/v ≤ most, as |y′| ≤ 3 √(most y), which follows from the jerk rules on both
  /// sides of the point.
  void keep_ramp(double most);
  /// Adds the time per length: weight · y^(−⅓).
  void add_time(double weight);

  [[nodiscard]] bool kept() const { return kept_; }
  [[nodiscard]] double value() const { return value_; }
  /// Derivatives by y, y′ and y″.
  [[nodiscard]] const std::array<double, 3>& gradient() const { return gradient_; }
  [[nodiscard]] double hessian(std::size_t i, std::size_t k) const { return hessian_[i][k]; }

 private:
  using Slope = std::array<double, 3>;
  void add_log(double room, const Slope& slope);
  void jerk_from_below(const AxisRule& axis, double sign);
  void jerk_from_above(const AxisRule& axis, double sign, const JerkRelief& relief);

  double y_;
  double first_;
  double second_;
  double speed_;
  bool kept_ = true;
  double value_ = 0.0;
  std::array<double, 3> gradient_{};
  std::array<std::array<double, 3>, 3> hessian_{};  ///< Upper half of the symmetric matrix.
};

}  // namespace sim
