#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"

namespace cnc::motion {

/// What a beam gave when it was measured. Integers, so that what is stored is
/// what was said.
struct PowerPoint {
  static constexpr std::uint32_t kFullDuty = 10'000;
  static constexpr std::uint32_t kMostMilliwatts = 10'000'000;

  std::uint16_t duty = 0;  ///< Hundredths of a percent of full output.
  std::uint32_t milliwatts = 0;
  constexpr bool operator==(const PowerPoint&) const = default;
};

enum class PowerTableError : std::uint8_t {
  kTooManyPoints,
  kBeyondRange,       ///< A duty above 100 %, or more than 10 kW.
  kLightWithoutDuty,  ///< Watts at a duty of 0.
  kDutyNotRising,     ///< Each duty is greater than the one before…
  kWattsNotRising,    ///< …and so are the watts.
};

/// How much light an output duty gives: points from dark to the greatest power, straight
/// between them. It begins at 0 % with 0 W, so a first point of 0 W is a threshold.
/// Strictly rising, so that it can be read from either side.
///
/// S means the share of the last point's watts; without points it is the duty.
class PowerTable {
 public:
  static constexpr std::size_t kMostPoints = 16;

  PowerTable() = default;
  [[nodiscard]] static Result<PowerTable, PowerTableError> make(std::span<const PowerPoint> points);

  [[nodiscard]] std::span<const PowerPoint> points() const { return {points_.data(), count_}; }

  /// The duty that gives a share of the greatest light, both 0…1; just short of
  /// the threshold for none. Error at most 3e-7. Rises with the share.
  [[nodiscard]] float duty_for(float share) const;
  /// The share of the greatest light that a duty gives, both 0…1. Error at most 3e-7.
  [[nodiscard]] float share_of(float duty) const;

  bool operator==(const PowerTable&) const = default;

 private:
  std::array<PowerPoint, kMostPoints> points_{};
  std::size_t count_ = 0;
};

/// From the light that is wanted to the output.
struct BeamResponse {
  PowerTable table{};
  float least_duty = 0.0F;  ///< 0…1; of a beam that follows the speed, as long as its S is not 0.
  bool operator==(const BeamResponse&) const = default;
};

}  // namespace cnc::motion
