#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "planner/base/coordinate.hpp"
#include "planner/base/result.hpp"

namespace cnc::gcode {

/// A number of G-code, exact to the ninth decimal.
///
/// Sign, whole part and billionths rather than one int64: reading, rounding and changing the unit
/// then need no 64-bit division, which a Cortex-M4 does not have.
struct Decimal {
  std::uint32_t whole = 0;       ///< At most 10^9.
  std::uint32_t billionths = 0;  ///< Below 10^9.
  bool minus = false;

  [[nodiscard]] constexpr bool is_integer() const { return billionths == 0; }
  /// Returns whether the number is below 0. False for −0, which a program may contain and which is
  /// harmless.
  [[nodiscard]] constexpr bool is_negative() const {
    return minus && (whole != 0 || billionths != 0);
  }
  /// Returns the number as a float, with a relative error of at most 2.5e-7: use this for speeds,
  /// times and powers, not for positions.
  [[nodiscard]] float to_float() const;
  [[nodiscard]] std::int64_t in_billionths() const;

  constexpr bool operator==(const Decimal&) const = default;
};

enum class DecimalError : std::uint8_t {
  kNoDigits,  ///< There is not even one digit, before or after the point.
  kTooLong,   ///< There are more than nine digits before the point, leading zeros not counted.
};

struct DecimalReading {
  Decimal value;
  std::size_t length = 0;  ///< Number of bytes that were read, including blanks after the number.
};

/// Reads an optional sign, digits, and an optional point with digits from the start of `text`, and
/// stops before any other character. Blanks between them have no effect (RS274/NGC 3.3.2). A tenth
/// decimal rounds the ninth, half away from zero. There are no exponents, no hexadecimals and no
/// NaN.
[[nodiscard]] Result<DecimalReading, DecimalError> read_decimal(std::string_view text);

/// Returns the coordinate for a number of millimetres, or of degrees on a rotary axis, to the
/// nearest nanometre or 10^-6 degree, half away from zero.
[[nodiscard]] Coordinate from_millimetres(const Decimal& number);

/// Returns the coordinate for a number of inches of exactly 25.4 mm, to the nearest nanometre.
[[nodiscard]] Coordinate from_inches(const Decimal& number);

/// Returns whether a character has no effect wherever it stands: a blank, or a control byte that
/// does not end a line. Grbl drops such bytes, too.
[[nodiscard]] constexpr bool is_blank(char c) {
  return static_cast<unsigned char>(c) <= ' ' && c != '\r' && c != '\n';
}

}  // namespace cnc::gcode
