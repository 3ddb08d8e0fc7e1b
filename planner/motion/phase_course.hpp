#pragma once

#include <cstdint>

#include "planner/motion/speed_profile.hpp"

namespace cnc::motion {

/// Time, way and speed within a phase, in equal units of at most a quarter of a
/// millisecond.
///
/// Way is a share of the phase, with x = time / duration and
/// α = 2 · start speed / (start speed + end speed): share = x (α + (1 − α) x).
/// In fixed point, so that a phase of an hour ends as exactly as it began and
/// nothing is left over for its last slice.
class PhaseCourse {
 public:
  static constexpr float kLongestUnit = 0.25e-3F;  ///< s.

  PhaseCourse() = default;
  /// @pre the duration is positive
  explicit PhaseCourse(const Phase& phase);

  [[nodiscard]] std::uint32_t units() const { return units_; }
  [[nodiscard]] float unit_s() const { return unit_s_; }
  /// Share of the phase's distance driven after so many units, Q32; @pre count < units().
  [[nodiscard]] std::uint32_t share_after(std::uint32_t count) const;
  /// mm/s after so many units.
  [[nodiscard]] float speed_after(std::uint32_t count) const;

 private:
  std::uint32_t units_ = 0;
  float unit_s_ = 0.0F;
  std::uint64_t unit_q62_ = 0;        ///< 1 / units().
  std::int64_t start_slope_q31_ = 0;  ///< α, 0…2.
  float start_speed_ = 0.0F;
  float end_speed_ = 0.0F;
};

}  // namespace cnc::motion
