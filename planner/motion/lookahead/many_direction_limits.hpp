#pragma once

#include "planner/motion/lookahead/arc_limits.hpp"
#include "planner/motion/lookahead/direction_box.hpp"
#include "planner/motion/lookahead/speed_change.hpp"

namespace cnc::motion {

/// Limits of a change of speed on an arc, if the directions of travel within the time window differ
/// much. For all these directions, the vectors of acceleration and jerk must be in the
/// DirectionBox. The object refers to its arguments, which must outlive it.
class ManyDirectionLimits {
 public:
  /// @param box the accelerations that are allowed in all directions within the window's reach of
  /// the span
  /// @param window_s length of the time window in s, above 0
  ManyDirectionLimits(const ArcShape& arc,
                      const ArcLimits& limits,
                      const DirectionBox& box,
                      const SpeedChange& change,
                      float window_s);

  /// Returns an acceleration along the path, ≤ `most` mm/s², that is in the box. A bisection
  /// searches for the greatest such acceleration. The bisection starts from an acceleration that is
  /// possible in any direction.
  [[nodiscard]] float steepest(float most) const;

 private:
  [[nodiscard]] bool holds(float steep) const;
  [[nodiscard]] float left_in_any_direction() const;

  const ArcShape& arc_;
  const ArcLimits& limits_;
  const DirectionBox& box_;
  const SpeedChange& change_;
  float window_s_;
  float cap_;  ///< Greatest speed along the path during the change, mm/s.
  float lag_;  ///< Result of lag_of(), s.
};

}  // namespace cnc::motion
