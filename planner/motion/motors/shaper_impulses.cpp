#include "planner/motion/motors/shaper_impulses.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {
namespace {

/// Residual swing of the EI shaper at its frequency, as a share. If this residual is accepted, the
/// residual swing at nearby frequencies does not exceed it either.
constexpr float kTolerance = 0.05F;
constexpr float kHalfSqrt2 = 0.70710678F;

ShaperImpulses scaled_to_one(ShaperImpulses impulses) {
  float sum = 0.0F;
  for (std::size_t i = 0; i < impulses.count; ++i) sum += impulses.amplitude[i];
  for (std::size_t i = 0; i < impulses.count; ++i) impulses.amplitude[i] /= sum;
  return impulses;
}

}  // namespace

float ShaperImpulses::mean_delay_s() const {
  float mean = 0.0F;
  for (std::size_t i = 0; i < count; ++i) mean += amplitude[i] * delay_s[i];
  return mean;
}

ShaperImpulses impulses_of(const ShaperSetting& setting) {
  const float root = std::sqrt(1.0F - square(setting.damping));
  const float half = 0.5F / (setting.frequency_hz * root);
  const float exponent = kPi * setting.damping / root;
  const float k = decay(exponent);
  switch (setting.kind) {
    case ShaperKind::kNone:
      break;
    case ShaperKind::kZv:
      return scaled_to_one({2, {1.0F, k}, {0.0F, half}});
    case ShaperKind::kZvd:
      return scaled_to_one({3, {1.0F, 2.0F * k, square(k)}, {0.0F, half, 2.0F * half}});
    case ShaperKind::kMzv: {
      const float later = decay(0.75F * exponent);
      const float outer = 1.0F - kHalfSqrt2;
      return scaled_to_one({3,
                            {outer, (2.0F * kHalfSqrt2 - 1.0F) * later, outer * square(later)},
                            {0.0F, 0.75F * half, 1.5F * half}});
    }
    case ShaperKind::kEi:
      return scaled_to_one(
          {3,
           {1.0F + kTolerance, 2.0F * (1.0F - kTolerance) * k, (1.0F + kTolerance) * square(k)},
           {0.0F, half, 2.0F * half}});
  }
  return {};
}

}  // namespace cnc::motion
