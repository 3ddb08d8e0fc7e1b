#pragma once

#include "planner/motion/lookahead/arc_limits.hpp"
#include "planner/motion/lookahead/speed_change.hpp"

namespace cnc::motion {

/// Limits of a change of speed on a span of an arc, if the directions of travel within the time
/// window differ little. Each axis is limited by its own shares of the tangent and of the normal.
/// The speed is known at one position (the known speed), and the change leads to the reached speed
/// at another position, see SpeedChange. The object refers to its arguments, which must outlive it.
class DirectionLimits {
 public:
  DirectionLimits(const ArcShape& arc, const ArcLimits& limits, const SpeedChange& change)
      : arc_{arc},
        limits_{limits},
        change_{change},
        bend_{square(arc.plane_share()) * arc.curvature()},
        sign_{static_cast<float>(change.change)},
        twice_along_{2.0F * change.distance * static_cast<float>(change.travel)} {}

  /// Returns the greatest acceleration ≤ `most` mm/s² for a change of speed between two positions.
  /// No axis exceeds its limit at `from` with the known speed, at `to` with the reached speed, or
  /// at either position with speed 0.
  [[nodiscard]] float between(const Place& from, const Place& to, float most) const {
    return at(to, Speeds::kReached, at(from, Speeds::kKnown, most));
  }
  /// Returns the greatest acceleration ≤ `most` mm/s² at a position whose speed may be the known or
  /// the reached speed. No axis exceeds its limit at either of these speeds or at speed 0.
  [[nodiscard]] float at_both_speeds(const Place& place, float most) const {
    return at(place, Speeds::kBoth, most);
  }
  /// Returns the greatest acceleration ≤ `most` mm/s² with which no axis exceeds its jerk limit in
  /// `directions`.
  /// @param window_s length of the time window in s, above 0
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
  float bend_;  ///< Bend (see Place) of an axis whose share in the normal is 1, 1/mm.
  float sign_;  ///< 1 for speeding up, −1 for slowing down.
  /// Twice the distance of the change along the path, mm; negative if the travel is backward.
  float twice_along_;
};

}  // namespace cnc::motion
