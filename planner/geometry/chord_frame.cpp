#include "planner/geometry/chord_frame.hpp"

#include <array>

namespace cnc {
namespace {

constexpr float kOneQ30 = 1073741824.0F;
constexpr float kOneQ31 = 2147483648.0F;
constexpr float kFromQ30 = 1.0F / kOneQ30;

constexpr std::int32_t q30(long double value) {
  return static_cast<std::int32_t>(value * 1073741824.0L + (value < 0.0L ? -0.5L : 0.5L));
}

/// a · b / 2^shift, rounded.
std::int32_t multiply(std::int32_t a, std::int32_t b, int shift) {
  const std::int64_t product = static_cast<std::int64_t>(a) * b;
  return static_cast<std::int32_t>((product + (std::int64_t{1} << (shift - 1))) >> shift);
}

// Interpolants of S and C at Chebyshev nodes over x² ≤ (π/2)², in powers of
// w = (x / 2)² so that no coefficient vanishes in Q30; error below 2e-11.
using Polynomial = std::array<std::int32_t, 6>;
constexpr Polynomial kSineQuotient{q30(0.9999999999828987L),
                                   q30(-0.16666666616765985L * 4),
                                   q30(0.00833333097233403L * 16),
                                   q30(-0.00019840860936542099L * 64),
                                   q30(2.752525717007601e-06L * 256),
                                   q30(-2.3888990176685845e-08L * 1024)};
constexpr Polynomial kVersineQuotient{q30(0.49999999999877304L),
                                      q30(-0.04166666663086609L * 4),
                                      q30(0.001388888719520905L * 16),
                                      q30(-2.4801294036003528e-05L * 64),
                                      q30(2.753433412673929e-07L * 256),
                                      q30(-2.0043675589406907e-09L * 1024)};

std::int32_t evaluate(const Polynomial& polynomial, std::int32_t w_q31) {
  std::int32_t sum = polynomial.back();
  for (std::size_t i = polynomial.size() - 1; i-- > 0;) {
    sum = polynomial[i] + multiply(sum, w_q31, 31);
  }
  return sum;
}

}  // namespace

ChordFrame::ChordFrame(float half_sweep)
    : half_sweep_{half_sweep},
      half_sweep_q30_{static_cast<std::int32_t>(half_sweep * kOneQ30)},
      quarter_square_q31_{multiply(half_sweep_q30_, half_sweep_q30_, 31)},
      inverse_sine_q30_{static_cast<std::int32_t>((std::int64_t{1} << 60) /
                                                  evaluate(kSineQuotient, quarter_square_q31_))},
      versine_q30_{evaluate(kVersineQuotient, quarter_square_q31_)} {}

ChordPoint ChordFrame::at(std::uint32_t fraction) const {
  const auto mu_q31 = static_cast<std::int32_t>(fraction ^ 0x8000'0000U);
  const std::int32_t mu_square_q30 = multiply(mu_q31, mu_q31, 32);
  const std::int32_t w_q31 = multiply(mu_square_q30, quarter_square_q31_, 30);
  const std::int32_t sine_quotient = evaluate(kSineQuotient, w_q31);
  const std::int32_t versine_quotient = evaluate(kVersineQuotient, w_q31);

  const std::int32_t sine_ratio =
      multiply(multiply(mu_q31, sine_quotient, 31), inverse_sine_q30_, 30);
  const std::int32_t height = versine_q30_ - multiply(mu_square_q30, versine_quotient, 30);
  // An arc that turns left lies to the right of its chord.
  const std::int32_t across =
      -multiply(multiply(half_sweep_q30_, height, 30), inverse_sine_q30_, 31);

  // cos(μh) = 1 − z C(z), with z = 4 w.
  const float cosine = 1.0F - 4.0F * (static_cast<float>(w_q31) / kOneQ31) *
                                  (static_cast<float>(versine_quotient) * kFromQ30);
  const float ratio = static_cast<float>(sine_ratio) * kFromQ30;
  return {.along_q30 = (1 << 29) + (sine_ratio >> 1),
          .across_q30 = across,
          .along_rate = cosine * (static_cast<float>(inverse_sine_q30_) * kFromQ30),
          .across_rate = half_sweep_ * ratio};
}

}  // namespace cnc
