#include "planner/geometry/chord_frame.hpp"

#include <algorithm>
#include <array>

namespace cnc {
namespace {

constexpr float kOneQ30 = 1073741824.0F;
constexpr float kFromQ31 = 1.0F / 2147483648.0F;

constexpr std::uint32_t kMaxQ31 = 0x7FFF'FFFF;

constexpr std::uint32_t q32(long double value) {
  return static_cast<std::uint32_t>(std::min(value * 4294967296.0L + 0.5L, 4294967295.0L));
}

/// Returns a · b of two numbers below 1, in Q32. On the controller this is one instruction.
constexpr std::uint32_t times(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>((std::uint64_t{a} * b) >> 32);
}

// Interpolants of S and C (see ChordFrame) at Chebyshev nodes over x² ≤ (π/2)², with an error below
// 2e-11. They are in powers of w = (x / 2)², so that no coefficient vanishes in Q32. The signs of
// the coefficients alternate, so each polynomial is evaluated as differences of numbers between 0
// and 1. The coefficients below are stored without signs.
using Polynomial = std::array<std::uint32_t, 6>;
constexpr Polynomial kSineQuotient{q32(0.9999999999828987L),
                                   q32(0.16666666616765985L * 4),
                                   q32(0.00833333097233403L * 16),
                                   q32(0.00019840860936542099L * 64),
                                   q32(2.752525717007601e-06L * 256),
                                   q32(2.3888990176685845e-08L * 1024)};
constexpr Polynomial kVersineQuotient{kMaxQ31,  // Just below ½, because a height has a sign bit.
                                      q32(0.04166666663086609L * 4),
                                      q32(0.001388888719520905L * 16),
                                      q32(2.4801294036003528e-05L * 64),
                                      q32(2.753433412673929e-07L * 256),
                                      q32(2.0043675589406907e-09L * 1024)};

constexpr std::uint32_t evaluate(const Polynomial& polynomial, std::uint32_t w) {
  std::uint32_t sum = polynomial.back();
  for (std::size_t i = polynomial.size() - 1; i-- > 0;) sum = polynomial[i] - times(sum, w);
  return sum;
}

/// Returns (h / 2)² in Q32.
std::uint32_t quarter_square(std::int32_t half_sweep_q30) {
  return static_cast<std::uint32_t>((std::int64_t{half_sweep_q30} * half_sweep_q30) >> 30);
}

}  // namespace

ChordFrame::ChordFrame(float half_sweep)
    : half_sweep_{half_sweep},
      quarter_square_q32_{quarter_square(static_cast<std::int32_t>(half_sweep * kOneQ30))},
      versine_q32_{evaluate(kVersineQuotient, quarter_square_q32_)} {
  const std::uint32_t sine_quotient = evaluate(kSineQuotient, quarter_square_q32_);
  inverse_sine_q31_ = static_cast<std::uint32_t>((std::uint64_t{1} << 63) / sine_quotient);
  inverse_sine_ = static_cast<float>(inverse_sine_q31_) * kFromQ31;
  const auto half_sweep_q30 = static_cast<std::int32_t>(half_sweep * kOneQ30);
  const std::int64_t product = std::int64_t{half_sweep_q30} * inverse_sine_q31_;
  height_scale_q29_ = static_cast<std::int32_t>(product >> 32);
}

ChordPoint ChordFrame::at(std::uint32_t fraction) const {
  const bool second_half = (fraction >> 31) != 0;
  // The magnitude |μ| in Q32.
  const std::uint32_t mu = second_half ? fraction << 1 : ~(fraction << 1);
  const std::uint32_t mu_square = times(mu, mu);
  const std::uint32_t w = times(mu_square, quarter_square_q32_);
  const std::uint32_t sine_quotient = evaluate(kSineQuotient, w);
  const std::uint32_t versine_quotient = evaluate(kVersineQuotient, w);

  // Near the ends the product may be rounded up to 1, which Q31 cannot represent.
  const std::uint32_t rounded = times(times(mu, sine_quotient), inverse_sine_q31_);
  const auto size_q31 = static_cast<std::int32_t>(std::min(rounded, kMaxQ31));
  const std::int32_t sine_ratio_q31 = second_half ? size_q31 : -size_q31;
  const auto height_q32 =
      static_cast<std::int32_t>(versine_q32_ - times(mu_square, versine_quotient));
  // An arc that turns left is to the right of its chord.
  const std::int64_t across_q62 = -(std::int64_t{height_scale_q29_} * height_q32);

  // cos(μh) = 1 − z C(z), with z = 4 w.
  const float cosine = 1.0F - 2.0F * kFromQ31 * static_cast<float>(times(w, versine_quotient));
  const float ratio = static_cast<float>(sine_ratio_q31) * kFromQ31;
  return {.along_q30 = (1 << 29) + (sine_ratio_q31 >> 2),
          .across_q30 = static_cast<std::int32_t>(across_q62 >> 32),
          .along_rate = cosine * inverse_sine_,
          .across_rate = half_sweep_ * ratio};
}

}  // namespace cnc
