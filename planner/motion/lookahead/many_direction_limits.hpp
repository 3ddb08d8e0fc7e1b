#pragma once

#include "planner/motion/lookahead/arc_limits.hpp"
#include "planner/motion/lookahead/direction_box.hpp"
#include "planner/motion/lookahead/speed_change.hpp"

namespace cnc::motion {

/// Limits of a change of speed on an arc where the window spans many directions. Acceleration and
/// jerk, as vectors along and across the path, must lie in the box of these directions. Lives only
/// as long as its arguments.
class ManyDirectionLimits {
 public:
  /// @param box for the directions that the window spans around the span
  /// @param window_s above 0
  ManyDirectionLimits(const ArcShape& arc,
                      const ArcLimits& limits,
                      const DirectionBox& box,
                      const SpeedChange& change,
                      float window_s);

  /// Returns an acceleration ≤ `most` mm/s² along the path that the box holds. A bisection looks
  /// for the greatest one, from an acceleration that turning leaves in any direction.
  [[nodiscard]] float steepest(float most) const;

 private:
  [[nodiscard]] bool holds(float steep) const;
  [[nodiscard]] float left_in_any_direction() const;

  const ArcShape& arc_;
  const ArcLimits& limits_;
  const DirectionBox& box_;
  const SpeedChange& change_;
  float window_s_;
  float cap_;  ///< Greatest speed during the change, mm/s.
  float lag_;  ///< s, see lag_of.
};

}  // namespace cnc::motion
