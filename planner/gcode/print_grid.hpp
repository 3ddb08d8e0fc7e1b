#pragma once

#include <concepts>
#include <cstdint>

#include "planner/base/contract.hpp"
#include "planner/base/truncate.hpp"

namespace cnc::gcode {

/// A position or a difference of positions, in units of the last printed digit. The printed text
/// has exactly this value, so results computed from it agree with the results of the reader.
struct GridPlace {
  std::int32_t x = 0;
  std::int32_t y = 0;

  constexpr bool operator==(const GridPlace&) const = default;
  friend constexpr GridPlace operator-(GridPlace a, GridPlace b) { return {a.x - b.x, a.y - b.y}; }
};

/// The number of digits after the point of a printed position.
class PrintGrid {
 public:
  /// Bounds of the number of digits. With fewer digits, rounded ends of small arcs would exceed
  /// Grbl's tolerance of 5 µm. Grbl reads at most eight digits of a number and would drop further
  /// digits.
  static constexpr std::uint8_t kFewest = 3;
  static constexpr std::uint8_t kMax = 5;

  /// @pre kFewest ≤ decimals ≤ kMax
  explicit constexpr PrintGrid(std::uint8_t decimals) : decimals_{decimals} {
    CNC_ASSERT(decimals >= kFewest && decimals <= kMax);
  }

  [[nodiscard]] constexpr std::uint8_t decimals() const { return decimals_; }
  /// Returns the number of units of the last printed digit in a millimetre.
  [[nodiscard]] constexpr std::int32_t per_mm() const {
    std::int32_t result = 1;
    for (std::uint8_t i = 0; i < decimals_; ++i) result *= 10;
    return result;
  }

 private:
  std::uint8_t decimals_;
};

/// Greatest distance of a position from zero, in units of the last printed digit. This is 5 m with
/// five decimals, and 500 m with three. So the difference of two positions fits into 32 bits.
inline constexpr std::int32_t kFarthestOnGrid = 500'000'000;

/// Greatest distance of a centre from the start of its arc, in tenths of the last printed digit.
/// This is 10 m with five decimals, and 1 km with three, which is the limit of the reader.
inline constexpr std::int64_t kFarthestCentre = 10'000'000'000;

/// Returns the nearest whole number; a half is rounded away from zero. @pre |value| < 2^47
template <std::floating_point Scalar>
[[nodiscard]] std::int64_t rounded(Scalar value) {
  const Scalar aside = value < 0 ? value - Scalar{0.5} : value + Scalar{0.5};
  if constexpr (std::same_as<Scalar, float>) {
    return truncated(aside);
  } else {
    return static_cast<std::int64_t>(aside);
  }
}

}  // namespace cnc::gcode
