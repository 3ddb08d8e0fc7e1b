#pragma once

#include "tests/support/optimal_time.hpp"
#include "tests/support/speed_rules.hpp"

namespace sim {

/// Returns the limits of the axes at a fraction of a curve.
[[nodiscard]] PlaceRules rules_at(const Curve& curve, double fraction, const MotionLimits& limits);

/// Upper bounds of the acceleration and jerk along the path by rules: t · (limits). For the jerk,
/// t″ adds −t · t″ v³ = |t′|² v³.
struct AlongPath {
  double acceleration = 0.0;  ///< Greatest acceleration, mm/s².
  double jerk = 0.0;          ///< Greatest jerk, mm/s³.
};

/// Computes the upper bounds. @param cap greatest v³, mm³/s³
[[nodiscard]] AlongPath along_path(const PlaceRules& rules, double cap);

}  // namespace sim
