#include "planner/motion/plan/phase_course.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/base/wide_multiply.hpp"

namespace cnc::motion {
namespace {

constexpr std::uint64_t kOneQ30 = std::uint64_t{1} << 30;
constexpr std::uint64_t kOneQ63 = std::uint64_t{1} << 63;

/// Greatest number of ticks for which the reciprocal has a relative error of at most 2^-30.
constexpr std::uint64_t kMaxTicks = std::uint64_t{1} << 33;

/// Number of additional bits of the reciprocal with Grain::kFine. For durations up to 18 minutes,
/// which are in ticks of a nanosecond, the relative error of the reciprocal is then at most 2^-47.
constexpr unsigned kRestBits = 24;
constexpr std::uint64_t kMaxFineTicks = std::uint64_t{1} << (64U - kRestBits);

}  // namespace

void PhaseCourse::divide() {
  const bool fine = grain_ == Grain::kFine;
  shift_ = 0;
  while ((whole_.duration_ns >> shift_) >= (fine ? kMaxFineTicks : kMaxTicks)) ++shift_;
  const std::uint64_t ticks = whole_.duration_ns >> shift_;
  per_tick_q63_ = kOneQ63 / ticks;
  if (fine) rest_q24_ = ((kOneQ63 - per_tick_q63_ * ticks) << kRestBits) / ticks;
  const float sum = whole_.start_speed + whole_.end_speed;
  const float alpha = sum > 0.0F ? std::min(2.0F * whole_.start_speed / sum, 2.0F) : 1.0F;
  start_slope_q30_ = static_cast<std::uint32_t>(alpha * static_cast<float>(kOneQ30));
}

PathUnits PhaseCourse::way_within(std::uint64_t ns) {
  if (per_tick_q63_ == 0) divide();
  if (grain_ == Grain::kFine) {
    return std::min(static_cast<PathUnits>(fine_way(ns >> shift_)), whole_.way);
  }
  const std::uint64_t x_q63 = (ns >> shift_) * per_tick_q63_;
  const auto whole = static_cast<std::uint64_t>(whole_.way);
  if (start_slope_q30_ == kOneQ30) return static_cast<PathUnits>(multiply_high(whole << 1, x_q63));
  const auto bend_q30 = static_cast<std::int64_t>(kOneQ30) -  // 1 − α.
                        static_cast<std::int64_t>(start_slope_q30_);
  const auto x_q32 = static_cast<std::int64_t>(x_q63 >> 31);
  const std::uint64_t slope_q62 =
      (start_slope_q30_ << 32) + static_cast<std::uint64_t>(bend_q30 * x_q32);
  const std::uint64_t share_q61 = multiply_high(x_q63, slope_q62);
  return std::min(static_cast<PathUnits>(multiply_high(whole << 3, share_q61)), whole_.way);
}

/// Computes the same distance as way_within(), but drops no digits.
/// @param ticks time since the start, in units of 2^shift_ ns
std::uint64_t PhaseCourse::fine_way(std::uint64_t ticks) const {
  const std::uint64_t x_q63 = ticks * per_tick_q63_ + ((ticks * rest_q24_) >> kRestBits);
  const bool slows_down = start_slope_q30_ > kOneQ30;
  const std::uint64_t bend_q30 =
      slows_down ? start_slope_q30_ - kOneQ30 : kOneQ30 - start_slope_q30_;
  const std::uint64_t bent_q62 = multiply_high(bend_q30 << 33, x_q63);
  const std::uint64_t start_q62 = start_slope_q30_ << 32;
  const std::uint64_t slope_q62 = slows_down ? start_q62 - bent_q62 : start_q62 + bent_q62;
  const std::uint64_t share_q61 = multiply_high(x_q63, slope_q62);
  return multiply_high(static_cast<std::uint64_t>(whole_.way) << 3, share_q61);
}

float PhaseCourse::speed_within(std::uint64_t ns) const {
  // Computed from the nearer end, because a difference from a large start speed would have few
  // digits near the end of a long braking.
  const float change = whole_.end_speed - whole_.start_speed;
  if (ns <= whole_.duration_ns / 2) {
    return whole_.start_speed + change * (nearest_float(ns) / duration_);
  }
  return whole_.end_speed - change * (nearest_float(whole_.duration_ns - ns) / duration_);
}

std::uint64_t PhaseCourse::time_of(PathUnits way, std::uint64_t from_ns) const {
  const float speed = speed_after(from_ns);
  const float distance = to_mm(way);
  const float end_square = square(speed) + 2.0F * whole_.acceleration * distance;
  const float sum = speed + std::sqrt(std::max(0.0F, end_square));
  const std::uint64_t left = whole_.duration_ns - from_ns;
  const float time_ns = 2.0F * distance * kNanosecondsPerSecond;
  if (time_ns >= sum * nearest_float(left)) return left;
  return std::min(left, static_cast<std::uint64_t>(truncated(time_ns / sum + 0.5F)));
}

}  // namespace cnc::motion
