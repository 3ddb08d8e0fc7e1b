#include "planner/motion/phase_course.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/truncate.hpp"

namespace cnc::motion {
namespace {

constexpr std::int64_t kOneQ31 = std::int64_t{1} << 31;

/// Longer phases, five days, get longer units.
constexpr float kMostUnits = 1.0e9F;

}  // namespace

PhaseCourse::PhaseCourse(const Phase& phase)
    : start_speed_{phase.start_speed}, end_speed_{std::sqrt(phase.end_speed_square)} {
  const float units = std::min(kMostUnits, std::ceil(phase.duration / kLongestUnit));
  units_ = std::max<std::uint32_t>(1, static_cast<std::uint32_t>(units));
  unit_s_ = phase.duration / static_cast<float>(units_);
  unit_q62_ = (std::uint64_t{1} << 62) / units_;
  const float alpha = 2.0F * start_speed_ / (start_speed_ + end_speed_);
  start_slope_q31_ = truncated(std::clamp(alpha, 0.0F, 2.0F) * static_cast<float>(kOneQ31));
}

std::uint32_t PhaseCourse::share_after(std::uint32_t count) const {
  const auto x_q32 = static_cast<std::int64_t>((unit_q62_ * count) >> 30);
  const std::int64_t bend_q31 = kOneQ31 - start_slope_q31_;
  const std::int64_t slope_q31 = start_slope_q31_ + ((bend_q31 * x_q32) >> 32);
  const std::int64_t share_q32 = (x_q32 * slope_q31) >> 31;
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(share_q32, 0, 0xFFFF'FFFF));
}

float PhaseCourse::speed_after(std::uint32_t count) const {
  // From the nearer end: what is left of a long braking is small.
  const auto whole = static_cast<float>(units_);
  if (count <= units_ / 2) {
    return start_speed_ + (end_speed_ - start_speed_) * (static_cast<float>(count) / whole);
  }
  const auto left = static_cast<float>(units_ - count);
  return end_speed_ + (start_speed_ - end_speed_) * (left / whole);
}

}  // namespace cnc::motion
