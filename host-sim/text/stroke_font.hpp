#pragma once

#include <optional>
#include <string_view>

namespace sim::text {

/// A letter of single strokes.
struct StrokeGlyph {
  double width = 0.0;       ///< Of the ink, in units.
  std::string_view path{};  ///< As the `d` of an SVG path in units, y upwards from the base line.
};

inline constexpr double kStrokeUnitsPerEm = 14.0;
inline constexpr double kStrokeCapital = 10.0;  ///< Height of capitals, in units.
inline constexpr double kStrokeSmall = 7.0;     ///< Height of x, in units.
inline constexpr double kStrokeDescent = 3.0;   ///< Below the base line, in units.
inline constexpr double kStrokeBearing = 1.3;   ///< Free on each side of a letter, in units.

/// Returns a letter of our own font: ASCII 32 to 126, a few signs of units, and dashes and quotes
/// as their ASCII forms. Nothing for other letters.
[[nodiscard]] std::optional<StrokeGlyph> stroke_glyph(char32_t letter);

}  // namespace sim::text
