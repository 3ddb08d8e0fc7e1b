#pragma once

#include <array>

#include "host-sim/measure/curve.hpp"

namespace sim {

/// What one axis, or all axes that move straight, may do at a place of the path.
struct AxisRule {
  double tangent = 0.0;       ///< t.
  double bend = 0.0;          ///< t′, 1/mm.
  double twist = 0.0;         ///< t″, 1/mm².
  double acceleration = 0.0;  ///< mm/s².
  double jerk = 0.0;          ///< mm/s³.
};

/// Round axes, two in a coordinate plane, and one for all that are straight.
struct PlaceRules {
  std::array<AxisRule, cnc::kAxisCount + 1> axes{};
  std::size_t count = 0;
};

/// What is taken for a²/v where an axis jerk is kept below its limit from above.
struct JerkRelief {
  bool exact = true;    ///< a²/v itself; else two upper bounds of it, whichever is less:
  double most = 0.0;    ///< a constant, mm/s³,
  double offset = 0.0;  ///< and offset − slope · y.
  double slope = 0.0;
};

/// The barrier of the rules at one place, as a function of y = v³ and its derivatives
/// y′ = 3 v a and y″ by length, with gradient and a positive semidefinite Hessian.
///
/// In y the motion rules are (nearly) convex, which they are not in v or v²:
///   axis acceleration  |t y′ + 3 t′ y| ≤ 3 A y^⅓                        (convex)
///   axis jerk          |t (y″/3 − y′²/9y) + t′ y′ + t″ y| ≤ J
/// y′²/9y = a²/v is convex, so of the jerk's two sides the one that lets t j fall is
/// convex; the other is not, and is what JerkRelief is about.
class PlaceBarrier {
 public:
  PlaceBarrier(double y, double first, double second);

  void keep_below(double cap);
  void keep_acceleration(const PlaceRules& rules);
  void keep_jerk(const PlaceRules& rules, const JerkRelief& relief);
  /// |y′| ≤ 3 √(most y): a²/v ≤ most, which follows from the jerk on both sides of the place.
  void keep_ramp(double most);
  /// weight · y^(−⅓): the time per length.
  void add_time(double weight);

  [[nodiscard]] bool kept() const { return kept_; }
  [[nodiscard]] double value() const { return value_; }
  /// By y, y′, y″.
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
  std::array<std::array<double, 3>, 3> hessian_{};  ///< Upper half.
};

}  // namespace sim
