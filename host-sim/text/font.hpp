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

/// Rows of curves, closed or open.
using Strokes = std::vector<std::vector<drawing::Shape>>;

/// The font that a drawing requests.
struct FontWish {
  std::string family{};   ///< Names separated by commas, as in CSS; may be empty.
  unsigned weight = 400;  ///< Weight of the font, 100 to 900.
  bool is_slanted = false;
  auto operator<=>(const FontWish&) const = default;
};

/// A glyph with its position in a line that begins at the origin, in em.
struct PlacedGlyph {
  /// Number of the glyph in the font; 0: the font does not have the letter.
  std::uint32_t glyph = 0;
  std::size_t byte = 0;  ///< Position in the text of the first letter that the glyph shows.
  drawing::Place offset{0.0, 0.0};
  double advance = 0.0;
};

/// Heights above the base line, in em.
struct FontFigures {
  double ascent = 0.8;
  double descent = 0.2;  ///< Depth below the base line.
  double capital = 0.7;
  double small = 0.5;  ///< Height of the letter x.
};

/// A scalable font of the system. Outlines are exactly those of its file.
class Font {
 public:
  /// Opens a font of a file. Returns nothing if the file contains no scalable font.
  [[nodiscard]] static std::unique_ptr<Font> open(const std::string& file, int index);
  virtual ~Font() = default;

  /// Returns the family and style, such as `DejaVu Sans Bold`.
  [[nodiscard]] virtual const std::string& name() const = 0;
  [[nodiscard]] virtual const FontFigures& figures() const = 0;
  [[nodiscard]] virtual bool has(char32_t letter) const = 0;
  /// Returns the glyphs of a line of one direction and script, with the kerning and ligatures of
  /// the font.
  [[nodiscard]] virtual std::vector<PlacedGlyph> shape(std::string_view words) = 0;
  /// Returns the closed outlines of a glyph in em, y upwards.
  [[nodiscard]] virtual const Strokes& outline(std::uint32_t glyph) = 0;
};

/// The fonts of the system.
class FontBook {
 public:
  FontBook();
  ~FontBook();
  FontBook(const FontBook&) = delete;
  FontBook& operator=(const FontBook&) = delete;

  /// Returns the font that is most similar to a wish and has the letter; null if the system has
  /// none.
  [[nodiscard]] Font* find(const FontWish& wish, char32_t letter = U' ');

 private:
  struct Library;

  std::unique_ptr<Library> library_;
  std::map<std::pair<std::string, int>, std::unique_ptr<Font>> fonts_;
  std::map<std::pair<FontWish, char32_t>, Font*> found_;
};

}  // namespace sim::text
