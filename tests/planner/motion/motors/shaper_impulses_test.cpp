#include "planner/motion/motors/shaper_impulses.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace cnc::motion {
namespace {

constexpr std::array kShapers{ShaperKind::kZv, ShaperKind::kZvd, ShaperKind::kMzv, ShaperKind::kEi};

/// Returns the amplitude of an oscillator after all impulses, relative to that after one impulse of
/// 1: Singer and Seering 1990, equation 2.
double residual(const ShaperImpulses& impulses, double frequency_hz, double damping) {
  const double omega = 2.0 * std::numbers::pi * frequency_hz;
  const double damped = omega * std::sqrt(1.0 - damping * damping);
  const auto last = static_cast<double>(impulses.delay_s[impulses.count - 1]);
  std::complex<double> sum{};
  for (std::size_t i = 0; i < impulses.count; ++i) {
    const auto delay = static_cast<double>(impulses.delay_s[i]);
    sum += static_cast<double>(impulses.amplitude[i]) *
           std::exp(std::complex<double>{damping * omega * (delay - last), damped * delay});
  }
  return std::abs(sum);
}

TEST(ShaperImpulses, AreAboveNoughtAndSumToOne) {
  for (const ShaperKind kind : kShapers) {
    for (const float damping : {0.0F, 0.1F, 0.5F}) {
      const ShaperImpulses impulses = impulses_of({kind, 37.0F, damping});
      float sum = 0.0F;
      for (std::size_t i = 0; i < impulses.count; ++i) {
        EXPECT_GT(impulses.amplitude[i], 0.0F);
        EXPECT_GE(impulses.delay_s[i], i == 0 ? 0.0F : impulses.delay_s[i - 1] + 1.0e-3F);
        sum += impulses.amplitude[i];
      }
      EXPECT_NEAR(sum, 1.0F, 3.0e-7F);
      EXPECT_EQ(impulses.delay_s[0], 0.0F);
    }
  }
}

TEST(ShaperImpulses, LeaveNoSwingAtTheirFrequency) {
  for (const float frequency : {10.0F, 41.5F, 200.0F}) {
    for (const float damping : {0.0F, 0.05F, 0.2F, 0.5F}) {
      for (const ShaperKind kind : {ShaperKind::kZv, ShaperKind::kZvd, ShaperKind::kMzv}) {
        const double left = residual(impulses_of({kind, frequency, damping}),
                                     static_cast<double>(frequency),
                                     static_cast<double>(damping));
        EXPECT_LT(left, 3.0e-6) << static_cast<int>(kind) << " " << frequency << " " << damping;
      }
    }
  }
}

/// EI allows 5 % at its frequency, and therefore no more than that within a fifth around it. ZVD is
/// flat there.
TEST(ShaperImpulses, AreAsRobustAsTheirNames) {
  const ShaperImpulses ei = impulses_of({ShaperKind::kEi, 50.0F, 0.0F});
  EXPECT_NEAR(residual(ei, 50.0, 0.0), 0.05, 1.0e-4);
  for (double off = 0.82; off <= 1.18; off += 0.01) {
    EXPECT_LT(residual(ei, 50.0 * off, 0.0), 0.0501) << off;
  }
  const ShaperImpulses zvd = impulses_of({ShaperKind::kZvd, 50.0F, 0.0F});
  EXPECT_LT(residual(zvd, 50.0 * 1.14, 0.0), 0.05);
  const ShaperImpulses zv = impulses_of({ShaperKind::kZv, 50.0F, 0.0F});
  EXPECT_GT(residual(zv, 50.0 * 1.14, 0.0), 0.2);
}

TEST(ShaperImpulses, OfNoShaperAreOne) {
  const ShaperImpulses none = impulses_of({});
  EXPECT_EQ(none.count, 1U);
  EXPECT_EQ(none.amplitude[0], 1.0F);
  EXPECT_EQ(none.mean_delay_s(), 0.0F);
}

}  // namespace
}  // namespace cnc::motion
