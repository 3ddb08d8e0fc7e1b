#pragma once

#include <compare>
#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/base/truncate.hpp"

namespace cnc {

inline constexpr float kMillimetresPerNanometre = 1.0e-6F;

/// A position on an axis in whole nanometres (rotary axes: 10^-6 degrees).
///
/// A float has 24 bits. At 1 m from the origin its resolution is 60 nm, and increments of 0.1 mm
/// accumulate error: a program with a million G91 lines would end at another position. Nanometres
/// represent every decimal that G-code can write (5 decimals of an inch are 254 nm). Sums of
/// nanometres are exact, and differences of near positions lose no digits before they become
/// floats.
class Coordinate {
 public:
  /// Greatest magnitude of a position that a program may name: 1 km, or a million degrees. The
  /// limit keeps every product with a steps-per-mm mantissa inside 64 bits.
  static constexpr std::int64_t kFarthestNanometres = 1'000'000'000'000;

  constexpr Coordinate() = default;
  constexpr explicit Coordinate(std::int64_t nanometres) : nanometres_{nanometres} {}

  [[nodiscard]] constexpr std::int64_t nanometres() const { return nanometres_; }
  /// Returns the coordinate in mm, with a relative error of at most 6e-8. Use this for differences,
  /// not for positions.
  [[nodiscard]] constexpr float mm() const {
    return nearest_float(nanometres_) * kMillimetresPerNanometre;
  }
  [[nodiscard]] constexpr bool in_range() const {
    return nanometres_ >= -kFarthestNanometres && nanometres_ <= kFarthestNanometres;
  }

  constexpr auto operator<=>(const Coordinate&) const = default;
  constexpr Coordinate operator-() const { return Coordinate{-nanometres_}; }
  constexpr Coordinate& operator+=(Coordinate other) {
    nanometres_ += other.nanometres_;
    return *this;
  }
  constexpr Coordinate& operator-=(Coordinate other) {
    nanometres_ -= other.nanometres_;
    return *this;
  }
  friend constexpr Coordinate operator+(Coordinate a, Coordinate b) { return a += b; }
  friend constexpr Coordinate operator-(Coordinate a, Coordinate b) { return a -= b; }

 private:
  std::int64_t nanometres_ = 0;
};

/// Returns the coordinate nearest to a number of millimetres (rotary axes: degrees).
/// @pre |mm| is at most 1e6.
[[nodiscard]] inline Coordinate from_mm(float mm) {
  // Whole millimetres are converted separately, so that the multiplication does not round them
  // again.
  const std::int64_t whole = truncated(mm);
  const float rest = (mm - static_cast<float>(whole)) * 1.0e6F;
  return Coordinate{whole * 1'000'000 + truncated(rest + (rest < 0.0F ? -0.5F : 0.5F))};
}

using Position = AxisArray<Coordinate>;

namespace literals {
constexpr Coordinate operator""_nm(unsigned long long v) {
  return Coordinate{static_cast<std::int64_t>(v)};
}
}  // namespace literals

}  // namespace cnc
