#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim::text {

/// Rows of connected curves, each closed or open.
using Strokes = std::vector<std::vector<drawing::Shape>>;

/// The properties of the font that a drawing requests.
struct FontWish {
  std::string family{};   ///< Names of font families, separated by commas as in CSS; may be empty.
  unsigned weight = 400;  ///< Weight of the font, 100 to 900.
  bool is_slanted = false;
  auto operator<=>(const FontWish&) const = default;
};

/// A glyph with its position in a line that begins at the origin, in em.
struct PlacedGlyph {
  /// Number of the glyph in the font; 0 if the font does not have the letter.
  std::uint32_t glyph = 0;
  std::size_t byte = 0;  ///< Index, in the text, of the first byte that the glyph represents.
  drawing::Place offset{0.0, 0.0};
  double advance = 0.0;
};

/// Dimensions of a font: heights above the base line, in em.
struct FontFigures {
  double ascent = 0.8;
  double descent = 0.2;  ///< Depth of letters below the base line, in em.
  double capital = 0.7;
  double small = 0.5;  ///< Height of the letter x, in em.
};

/// A scalable font of the system. Its outlines are exactly those of the font file.
class Font {
 public:
  /// Opens font number `index` of a font file. Returns null if the file contains no such scalable
  /// font.
  [[nodiscard]] static std::unique_ptr<Font> open(const std::string& file, int index);
  virtual ~Font() = default;

  /// Returns the name of family and style, such as `DejaVu Sans Bold`.
  [[nodiscard]] virtual const std::string& name() const = 0;
  [[nodiscard]] virtual const FontFigures& figures() const = 0;
  [[nodiscard]] virtual bool has(char32_t letter) const = 0;
  /// Returns the glyphs of a line, with the kerning and ligatures of the font. All letters of the
  /// line must have the same direction and script.
  [[nodiscard]] virtual std::vector<PlacedGlyph> shape(std::string_view words) = 0;
  /// Returns the closed outlines of a glyph, in em, with y upwards.
  [[nodiscard]] virtual const Strokes& outline(std::uint32_t glyph) = 0;
};

/// The fonts that the system provides, which are opened when they are needed.
class FontBook {
 public:
  FontBook();
  ~FontBook();
  FontBook(const FontBook&) = delete;
  FontBook& operator=(const FontBook&) = delete;

  /// Returns the font that is most similar to a wish and has the letter; null if no font has it.
  [[nodiscard]] Font* find(const FontWish& wish, char32_t letter = U' ');

 private:
  struct Library;

  std::unique_ptr<Library> library_;
  std::map<std::pair<std::string, int>, std::unique_ptr<Font>> fonts_;
  std::map<std::pair<FontWish, char32_t>, Font*> found_;
};

}  // namespace sim::text
