#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/result.hpp"

namespace cnc::motion {

/// A measured point of a beam: a duty of the output, and the power at this duty. Both are integers,
/// so that the stored values are exactly those that were entered.
struct PowerPoint {
  static constexpr std::uint32_t kFullDuty = 10'000;
  static constexpr std::uint32_t kMaxMilliwatts = 10'000'000;

  std::uint16_t duty = 0;  ///< Duty in hundredths of a percent of full output.
  std::uint32_t milliwatts = 0;
  constexpr bool operator==(const PowerPoint&) const = default;
};

enum class PowerTableError : std::uint8_t {
  kTooManyPoints,
  kBeyondRange,       ///< A duty is above 100 %, or a power is above 10 kW.
  kLightWithoutDuty,  ///< A power is above 0 W at a duty of 0.
  kDutyNotRising,     ///< A duty is not greater than the duty of the point before it.
  /// A power is not greater than the power of the point before it, or the last power is 0 W.
  kWattsNotRising,
};

/// The power of a beam as a function of the output's duty: points in rising order, with straight
/// lines between them. The table begins at 0 % with 0 W. So if the first point has 0 W, its duty is
/// a threshold, up to which the beam has no power. Duty and power both rise strictly, so each can
/// be computed from the other.
///
/// The S word gives the required power as a share of the last point's power. Without points, the S
/// word gives the duty itself.
class PowerTable {
 public:
  static constexpr std::size_t kMaxPoints = 16;

  PowerTable() = default;
  [[nodiscard]] static Result<PowerTable, PowerTableError> make(std::span<const PowerPoint> points);

  [[nodiscard]] std::span<const PowerPoint> points() const { return {points_.data(), count_}; }

  /// Returns the duty for a share of the greatest power, both 0…1. The duty rises with the share.
  /// For a share of 0, the result is the threshold. The error is at most 3e-7.
  [[nodiscard]] float duty_for(float share) const;
  /// Returns the share of the greatest power at a duty, both 0…1. The error is at most 3e-7.
  [[nodiscard]] float share_of(float duty) const;

  bool operator==(const PowerTable&) const = default;

 private:
  std::array<PowerPoint, kMaxPoints> points_{};
  std::size_t count_ = 0;
};

/// Relation between the required power of a beam and the duty of its output.
struct BeamResponse {
  PowerTable table{};
  /// Least duty, 0…1, of a beam whose power follows the speed, unless the S word is 0.
  float min_duty = 0.0F;
  bool operator==(const BeamResponse&) const = default;
};

}  // namespace cnc::motion
