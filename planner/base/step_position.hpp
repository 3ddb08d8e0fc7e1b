#pragma once

#include <cstdint>
#include <optional>

#include "planner/base/contract.hpp"
#include "planner/base/coordinate.hpp"

namespace cnc {

/// A position on a motor axis in steps, Q32.32: 2^32 stands for one step.
///
/// The number is an integer, so that positions accumulate without error and chip and host agree to
/// the bit. It has a fraction because a block rarely ends on a whole step.
class StepPosition {
 public:
  static constexpr float kStepsPerUnit = 1.0F / 4294967296.0F;

  constexpr StepPosition() = default;
  constexpr explicit StepPosition(std::int64_t q32) : q32_{q32} {}
  [[nodiscard]] static constexpr StepPosition whole(std::int32_t steps) {
    return StepPosition{static_cast<std::int64_t>(steps) * (std::int64_t{1} << 32)};
  }

  [[nodiscard]] constexpr std::int64_t q32() const { return q32_; }

  /// Returns the motor step nearest to this position. A half rounds away from zero, as with lround.
  [[nodiscard]] constexpr std::int32_t nearest_step() const {
    const std::int64_t half = (std::int64_t{1} << 31) - (q32_ < 0 ? 1 : 0);
    return static_cast<std::int32_t>((q32_ + half) >> 32);
  }

  constexpr bool operator==(const StepPosition&) const = default;

 private:
  std::int64_t q32_ = 0;
};

/// Resolution of one axis. The float setting is stored as mantissa and exponent, so that conversion
/// is exact integer arithmetic.
class AxisScale {
 public:
  static constexpr float kMinStepsPerMm = 0.01F;
  static constexpr float kMaxStepsPerMm = 100'000.0F;
  /// Greatest magnitude of a motor position in steps: half of the range of 32 bits, so that no
  /// difference of two positions overflows.
  static constexpr std::int64_t kMaxSteps = (std::int64_t{1} << 30);

  constexpr AxisScale() : AxisScale{250.0F} {}
  /// @pre kMinStepsPerMm ≤ steps_per_mm ≤ kMaxStepsPerMm
  explicit constexpr AxisScale(float steps_per_mm);

  [[nodiscard]] constexpr float steps_per_mm() const { return steps_per_mm_; }

  /// Returns whether steps_at() has a result for this position.
  [[nodiscard]] bool reaches(Coordinate place) const;
  /// Converts a position to steps, exact to 2^-32 step. The result is empty if the position is
  /// beyond kMaxSteps.
  [[nodiscard]] std::optional<StepPosition> steps_at(Coordinate place) const;
  /// Converts a length to steps with a relative error of at most 1.2e-7. The result is empty if the
  /// length is beyond kMaxSteps.
  [[nodiscard]] std::optional<StepPosition> steps_of(float mm) const;

  /// Returns the coordinate of a whole step, to the nearest nanometre.
  [[nodiscard]] Coordinate place_of(std::int32_t step) const;

 private:
  float steps_per_mm_;
  std::uint32_t mantissa_ = 0;  ///< Mantissa: steps_per_mm = mantissa_ · 2^-fraction_bits_.
  int fraction_bits_ = 0;
};

constexpr AxisScale::AxisScale(float steps_per_mm) : steps_per_mm_{steps_per_mm} {
  CNC_ASSERT(steps_per_mm >= kMinStepsPerMm && steps_per_mm <= kMaxStepsPerMm);
  // Doubles until 2^23 ≤ scaled < 2^24: at most 30 times, because 0.01 > 2^-7.
  float scaled = steps_per_mm;
  while (scaled < 8388608.0F) {
    scaled *= 2.0F;
    ++fraction_bits_;
  }
  mantissa_ = static_cast<std::uint32_t>(scaled);
}

}  // namespace cnc
