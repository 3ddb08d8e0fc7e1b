#pragma once

#include "planner/motion/lookahead/arc_limits.hpp"
#include "planner/motion/lookahead/speed_change.hpp"

namespace cnc::motion {

/// Limits of a change of speed on a span of an arc whose directions are distinguished: each axis
/// takes its own share of the tangent and of the normal. Lives only as long as its arguments.
class DirectionLimits {
 public:
  DirectionLimits(const ArcShape& arc, const ArcLimits& limits, const SpeedChange& change)
      : arc_{arc},
        limits_{limits},
        change_{change},
        bend_{square(arc.plane_share()) * arc.curvature()},
        sign_{static_cast<float>(change.change)},
        twice_along_{2.0F * change.distance * static_cast<float>(change.travel)} {}

  /// Returns the greatest acceleration ≤ `most` mm/s² for which no axis exceeds its limit at
  /// `from`, where the speed is known, nor at `to`, nor at either of them at speed 0.
  [[nodiscard]] float between(const Place& from, const Place& to, float most) const {
    return at(to, Speeds::kReached, at(from, Speeds::kKnown, most));
  }
  /// Returns the greatest acceleration ≤ `most` mm/s² at a position that may have the known or the
  /// reached speed. No axis exceeds its limit at either speed, nor at speed 0.
  [[nodiscard]] float at_both_speeds(const Place& place, float most) const {
    return at(place, Speeds::kBoth, most);
  }
  /// Returns the greatest acceleration ≤ `most` mm/s² with which no axis exceeds its jerk in these
  /// directions.
  /// @param window_s above 0
  [[nodiscard]] float within_jerk(const DirectionRange& directions,
                                  float most,
                                  float window_s) const;

 private:
  enum class Speeds : std::uint8_t { kKnown, kReached, kBoth };

  [[nodiscard]] float at(const Place& place, Speeds speeds, float most) const;
  [[nodiscard]] float within_jerk_at(float speed,
                                     const AxisArray<AxisShares>& shares,
                                     float most,
                                     float window_s) const;

  const ArcShape& arc_;
  const ArcLimits& limits_;
  const SpeedChange& change_;
  float bend_;         ///< Bend along the path, 1/mm.
  float sign_;         ///< Sign of the change of speed.
  float twice_along_;  ///< Twice the distance along the path, mm; below 0 against it.
};

}  // namespace cnc::motion
