#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "planner/base/coordinate.hpp"
#include "planner/base/result.hpp"

namespace cnc::gcode {

/// A number of G-code, exact to the ninth decimal.
///
/// It consists of a sign, a whole part and billionths instead of one int64. So reading, rounding
/// and converting it require no 64-bit division, which a Cortex-M4 does not have.
struct Decimal {
  std::uint32_t whole = 0;       ///< At most 10^9.
  std::uint32_t billionths = 0;  ///< Below 10^9.
  bool minus = false;

  [[nodiscard]] constexpr bool is_integer() const { return billionths == 0; }
  /// Returns whether the number is below 0. Returns false for −0, which may occur in a program and
  /// does no harm.
  [[nodiscard]] constexpr bool is_negative() const {
    return minus && (whole != 0 || billionths != 0);
  }
  /// Returns the number as a float with a relative error of at most 2.5e-7. It is for speeds, times
  /// and powers, not for positions.
  [[nodiscard]] float to_float() const;
  [[nodiscard]] std::int64_t in_billionths() const;

  constexpr bool operator==(const Decimal&) const = default;
};

enum class DecimalError : std::uint8_t {
  kNoDigits,  ///< There is no digit, neither before nor after the point.
  kTooLong,   ///< There are more than nine digits before the point, without leading zeros.
};

struct DecimalReading {
  Decimal value;
  std::size_t length = 0;  ///< Number of bytes that were read, including blanks after the number.
};

/// Reads a number from the start of `text`: an optional sign, digits, and optionally a point with
/// more digits. Stops before any other character. Blanks between these characters have no effect
/// (RS274/NGC 3.3.2). Decimals after the ninth round it, half away from zero. Exponents,
/// hexadecimal numbers and NaN are not supported.
[[nodiscard]] Result<DecimalReading, DecimalError> read_decimal(std::string_view text);

/// Returns the coordinate for a number of millimetres or, on a rotary axis, of degrees. It is
/// rounded to the nearest nanometre or 10^-6 degree, half away from zero.
[[nodiscard]] Coordinate from_millimetres(const Decimal& number);

/// Returns the coordinate for a number of inches of exactly 25.4 mm, rounded to the nearest
/// nanometre.
[[nodiscard]] Coordinate from_inches(const Decimal& number);

/// Returns whether a character has no effect anywhere in a line. This holds for blanks and for
/// control bytes that do not end a line. Grbl ignores these bytes, too.
[[nodiscard]] constexpr bool is_blank(char c) {
  return static_cast<unsigned char>(c) <= ' ' && c != '\r' && c != '\n';
}

}  // namespace cnc::gcode
