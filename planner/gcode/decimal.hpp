#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "planner/base/coordinate.hpp"
#include "planner/base/result.hpp"

namespace cnc::gcode {

/// A number of G-code, exact to the ninth decimal.
///
/// Sign, whole part and billionths rather than one int64: reading, rounding and
/// changing the unit then need no 64-bit division, which a Cortex-M4 has not.
struct Decimal {
  std::uint32_t whole = 0;       ///< At most 10^9.
  std::uint32_t billionths = 0;  ///< Below 10^9.
  bool minus = false;

  [[nodiscard]] constexpr bool is_integer() const { return billionths == 0; }
  /// False for −0, which is written but harmless.
  [[nodiscard]] constexpr bool is_negative() const {
    return minus && (whole != 0 || billionths != 0);
  }
  /// Relative error at most 2.5e-7: for speeds, times and powers, not for places.
  [[nodiscard]] float to_float() const;
  [[nodiscard]] std::int64_t in_billionths() const;

  constexpr bool operator==(const Decimal&) const = default;
};

enum class DecimalError : std::uint8_t {
  kNoDigits,  ///< Not even one digit, before or after the point.
  kTooLong,   ///< More than nine digits before the point, leading zeros apart.
};

struct DecimalReading {
  Decimal value;
  std::size_t length = 0;  ///< Bytes that the number takes, blanks after it included.
};

/// Reads an optional sign, digits, and an optional point with digits from the
/// start of `text`, and stops before whatever else follows. Blanks anywhere
/// among them mean nothing (RS274/NGC 3.3.2). A tenth decimal rounds the ninth,
/// half away from zero. There are no exponents, no hexadecimals and no NaN.
[[nodiscard]] Result<DecimalReading, DecimalError> read_decimal(std::string_view text);

/// The place that a number of millimetres names, or of degrees on a rotary
/// axis, to the nearest nanometre or 10^-6 degree, half away from zero.
[[nodiscard]] Coordinate from_millimetres(const Decimal& number);

/// The same for inches; 25.4 mm each, exactly.
[[nodiscard]] Coordinate from_inches(const Decimal& number);

/// Means nothing wherever it stands: a blank, or a control byte that ends no line. Grbl drops
/// those, too.
[[nodiscard]] constexpr bool is_blank(char c) {
  return static_cast<unsigned char>(c) <= ' ' && c != '\r' && c != '\n';
}

}  // namespace cnc::gcode
