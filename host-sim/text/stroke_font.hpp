#pragma once

#include <optional>
#include <string_view>

namespace sim::text {

/// A letter that consists of single strokes.
struct StrokeGlyph {
  double width = 0.0;  ///< Width of the ink, in units.
  /// Strokes as the `d` of an SVG path, in units, y upwards from the base line.
  std::string_view path{};
};

inline constexpr double kStrokeUnitsPerEm = 14.0;
inline constexpr double kStrokeCapital = 10.0;  ///< Height of capitals, in units.
inline constexpr double kStrokeSmall = 7.0;     ///< Height of the letter x, in units.
/// Greatest depth of letters below the base line, in units.
inline constexpr double kStrokeDescent = 3.0;
/// Free distance on each side of a letter, in units.
inline constexpr double kStrokeBearing = 1.3;

/// Returns a letter of the built-in stroke font. It has ASCII 32 to 126 and a few signs of units.
/// Dashes and quotes of other forms are returned as their ASCII forms. Returns nothing for other
/// letters.
[[nodiscard]] std::optional<StrokeGlyph> stroke_glyph(char32_t letter);

}  // namespace sim::text
