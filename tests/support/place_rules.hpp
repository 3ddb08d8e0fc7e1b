#pragma once

#include "tests/support/optimal_time.hpp"
#include "tests/support/speed_rules.hpp"

namespace sim {

/// What the axes may do at a fraction of a curve.
[[nodiscard]] PlaceRules rules_at(const Curve& curve, double fraction, const MotionLimits& limits);

/// The greatest that rules allow along the path, or more: t · (limits), and for the
/// jerk what t″ adds, −t · t″ v³ = |t′|² v³.
struct AlongPath {
  double acceleration = 0.0;  ///< mm/s².
  double jerk = 0.0;          ///< mm/s³.
};

/// @param cap the greatest v³, mm³/s³.
[[nodiscard]] AlongPath along_path(const PlaceRules& rules, double cap);

}  // namespace sim
