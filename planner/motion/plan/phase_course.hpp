#pragma once

#include <cstdint>

#include "planner/motion/block/path_units.hpp"

namespace cnc::motion {

/// A stretch of motion along the path with constant acceleration.
struct Stretch {
  PathUnits way = 0;  ///< Distance along the path, ≥ 0.
  std::uint64_t duration_ns = 0;
  float start_speed = 0.0F;  ///< Speed at the start, mm/s, ≥ 0.
  float end_speed = 0.0F;
  float acceleration = 0.0F;  ///< Acceleration along the path, mm/s²; negative when braking.

  /// Returns whether the stretch takes time. A duration of 0 means that there is no stretch.
  [[nodiscard]] bool lasts() const { return duration_ns > 0; }
};

inline constexpr float kSecondsPerNanosecond = 1.0e-9F;
inline constexpr float kNanosecondsPerSecond = 1.0e9F;

/// Distance and speed as functions of time at constant acceleration.
///
/// With x = time / duration and α = 2 · start speed / (start speed + end speed), the distance at
/// that time is whole distance · x (α + (1 − α) x). The distance is computed in fixed point, so
/// that it is as exact at the end of an hour as at its start. It never decreases, and is exact at
/// both ends. Its error is at most 2^-32 of the whole distance or, with Grain::kFine, two path
/// units.
class PhaseCourse {
 public:
  /// Resolution of the distance. Under a time window, kFine is used, because jerk is computed from
  /// third differences of positions at intervals of a millisecond (a cell). In a phase of ten
  /// seconds, an error of 2^-32 of the distance would be visible in these differences.
  enum class Grain : std::uint8_t { kUsual, kFine };

  PhaseCourse() = default;
  /// Makes the profile of a stretch. @pre the duration of the stretch is positive
  explicit PhaseCourse(const Stretch& stretch, Grain grain = Grain::kUsual) {
    begin(stretch, grain);
  }
  /// Replaces the profile by the profile of another stretch. @pre the duration of the stretch is
  /// positive
  void begin(const Stretch& stretch, Grain grain = Grain::kUsual) {
    whole_ = stretch;
    duration_ = nearest_float(stretch.duration_ns);
    per_tick_q63_ = 0;
    grain_ = grain;
  }

  [[nodiscard]] std::uint64_t duration_ns() const { return whole_.duration_ns; }
  /// Returns the distance at the time `ns` after the start. @pre ns ≤ duration_ns()
  [[nodiscard]] PathUnits way_after(std::uint64_t ns) {
    return ns >= whole_.duration_ns ? whole_.way : way_within(ns);
  }
  /// Returns the speed at the time `ns` after the start, in mm/s.
  [[nodiscard]] float speed_after(std::uint64_t ns) const {
    return ns >= whole_.duration_ns ? whole_.end_speed : speed_within(ns);
  }
  /// Returns the time in ns, counted from `from_ns`, that the motion takes for the next distance
  /// `way`. The time is limited to the end of the stretch.
  [[nodiscard]] std::uint64_t time_of(PathUnits way, std::uint64_t from_ns) const;
  [[nodiscard]] const Stretch& whole() const { return whole_; }

 private:
  [[nodiscard]] PathUnits way_within(std::uint64_t ns);
  [[nodiscard]] float speed_within(std::uint64_t ns) const;
  void divide();
  [[nodiscard]] std::uint64_t fine_way(std::uint64_t ticks) const;

  Stretch whole_{};
  float duration_ = 0.0F;  ///< Duration of the stretch, ns.
  /// 2^63 / duration, with the duration in ticks of 2^shift_ ns. It stays 0 until a position inside
  /// the stretch is evaluated, because the division is slow and most stretches are evaluated only
  /// at their end.
  std::uint64_t per_tick_q63_ = 0;
  std::uint64_t start_slope_q30_ = 0;  ///< α in Q30, 0…2.
  /// With kFine, the next 24 binary digits of the reciprocal after those of per_tick_q63_.
  std::uint64_t rest_q24_ = 0;
  /// Number of bits by which times in ns are shifted to ticks; set together with per_tick_q63_.
  unsigned shift_ = 0;
  Grain grain_ = Grain::kUsual;
};

}  // namespace cnc::motion
