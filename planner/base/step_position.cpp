#include "planner/base/step_position.hpp"

namespace cnc {
namespace {
constexpr std::uint64_t kNanometresPerMm = 1'000'000;
}

bool AxisScale::reaches(Coordinate place) const {
  constexpr std::uint64_t kMax = static_cast<std::uint64_t>(kMaxSteps) * kNanometresPerMm;
  if (!place.in_range()) return false;
  const std::int64_t nm = place.nanometres();
  return (static_cast<std::uint64_t>(nm < 0 ? -nm : nm) * mantissa_) >> fraction_bits_ < kMax;
}

std::optional<StepPosition> AxisScale::steps_at(Coordinate place) const {
  if (!place.in_range()) return std::nullopt;
  const bool negative = place < Coordinate{};
  const auto distance =
      static_cast<std::uint64_t>(negative ? -place.nanometres() : place.nanometres());
  // The product is below 2^40 · 2^24, so it fits into 64 bits. Steps = product / 10^6 /
  // 2^fraction_bits_.
  const std::uint64_t product = distance * mantissa_;
  const std::uint64_t quotient = product / kNanometresPerMm;
  const std::uint64_t remainder = product % kNanometresPerMm;
  if ((quotient >> fraction_bits_) >= static_cast<std::uint64_t>(kMaxSteps)) return std::nullopt;
  const int shift = 32 - fraction_bits_;  // The shift is 2…25, because fraction_bits_ is 7…30.
  const std::uint64_t fraction = ((remainder << shift) + kNanometresPerMm / 2) / kNanometresPerMm;
  const auto q32 = static_cast<std::int64_t>((quotient << shift) + fraction);
  return StepPosition{negative ? -q32 : q32};
}

std::optional<StepPosition> AxisScale::steps_of(float mm) const {
  constexpr float kQ16 = 65'536.0F;
  // Number of steps up to which steps · 2^32 is within the range of truncated().
  constexpr float kFew = 16'384.0F;
  constexpr auto kMax = static_cast<float>(kMaxSteps);
  const float steps = mm * steps_per_mm_;
  if (!(steps > -kMax && steps < kMax)) return std::nullopt;
  const bool few = steps > -kFew && steps < kFew;
  return StepPosition{few ? truncated(steps * kQ16 * kQ16) : truncated(steps * kQ16) * 65'536};
}

Coordinate AxisScale::place_of(std::int32_t step) const {
  const bool negative = step < 0;
  const auto count = static_cast<std::uint64_t>(negative ? -static_cast<std::int64_t>(step) : step);
  // nm = count · 10^6 · 2^fraction_bits_ / mantissa_, computed in two parts below 2^64.
  const std::uint64_t numerator = count * kNanometresPerMm;
  const std::uint64_t whole = numerator / mantissa_;
  const std::uint64_t rest = numerator % mantissa_;
  const std::uint64_t nm =
      (whole << fraction_bits_) + ((rest << fraction_bits_) + mantissa_ / 2) / mantissa_;
  const auto result = static_cast<std::int64_t>(nm);
  return Coordinate{negative ? -result : result};
}

}  // namespace cnc
