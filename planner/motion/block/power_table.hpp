#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"

namespace cnc::motion {

/// A measured point of a beam: an output duty and its power. Both are integers, so that the stored
/// values are exactly those that were entered.
struct PowerPoint {
  static constexpr std::uint32_t kFullDuty = 10'000;
  static constexpr std::uint32_t kMaxMilliwatts = 10'000'000;

  std::uint16_t duty = 0;  ///< Hundredths of a percent of full output.
  std::uint32_t milliwatts = 0;
  constexpr bool operator==(const PowerPoint&) const = default;
};

enum class PowerTableError : std::uint8_t {
  kTooManyPoints,
  kBeyondRange,       ///< A duty above 100 %, or more than 10 kW.
  kLightWithoutDuty,  ///< Watts at a duty of 0.
  kDutyNotRising,     ///< A duty is not greater than the one before it.
  kWattsNotRising,    ///< A power is not greater than the one before it, or the last is 0 W.
};

/// How much light an output duty gives: points from no power to the greatest, with straight lines
/// between them. The table begins at 0 % with 0 W, so a first point of 0 W is a threshold. Duty and
/// power both rise strictly, so the table can be read in both directions.
///
/// S means the share of the last point's watts. Without points S is the duty.
class PowerTable {
 public:
  static constexpr std::size_t kMaxPoints = 16;

  PowerTable() = default;
  [[nodiscard]] static Result<PowerTable, PowerTableError> make(std::span<const PowerPoint> points);

  [[nodiscard]] std::span<const PowerPoint> points() const { return {points_.data(), count_}; }

  /// Returns the duty that gives a share of the greatest light, both 0…1. The duty rises with the
  /// share; for a share of 0 it is the threshold, up to which there is no light. Error at most
  /// 3e-7.
  [[nodiscard]] float duty_for(float share) const;
  /// Returns the share of the greatest light that a duty gives, both 0…1. Error at most 3e-7.
  [[nodiscard]] float share_of(float duty) const;

  bool operator==(const PowerTable&) const = default;

 private:
  std::array<PowerPoint, kMaxPoints> points_{};
  std::size_t count_ = 0;
};

/// How the output duty of a beam follows from the required light.
struct BeamResponse {
  PowerTable table{};
  /// Least duty, 0…1, of a beam that follows the speed, while its S is not 0.
  float min_duty = 0.0F;
  bool operator==(const BeamResponse&) const = default;
};

}  // namespace cnc::motion
