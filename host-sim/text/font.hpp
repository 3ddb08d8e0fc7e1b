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

/// Closed or open rows of curves.
using Strokes = std::vector<std::vector<drawing::Shape>>;

/// The font that a drawing wishes.
struct FontWish {
  std::string family{};   ///< As CSS has it: names with commas; may be empty.
  unsigned weight = 400;  ///< 100 to 900.
  bool is_slanted = false;
  auto operator<=>(const FontWish&) const = default;
};

/// A glyph where it stands in a line that begins at the origin, in em.
struct PlacedGlyph {
  std::uint32_t glyph = 0;  ///< 0: the font does not have the letter.
  std::size_t byte = 0;     ///< Of the first letter that it shows.
  drawing::Place offset{0.0, 0.0};
  double advance = 0.0;
};

/// Heights over the base line, in em.
struct FontFigures {
  double ascent = 0.8;
  double descent = 0.2;  ///< Below the base line.
  double capital = 0.7;
  double small = 0.5;  ///< Of the letter x.
};

/// A scalable font of the system. Outlines are exactly those of its file.
class Font {
 public:
  /// Nothing where the file holds no scalable font.
  [[nodiscard]] static std::unique_ptr<Font> open(const std::string& file, int index);
  virtual ~Font() = default;

  /// Returns family and style, as `DejaVu Sans Bold`.
  [[nodiscard]] virtual const std::string& name() const = 0;
  [[nodiscard]] virtual const FontFigures& figures() const = 0;
  [[nodiscard]] virtual bool has(char32_t letter) const = 0;
  /// Returns the glyphs of a line of one direction and script, kerned and joined as the font says.
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

  /// Returns the font nearest to a wish that has the letter; null where the system has none.
  [[nodiscard]] Font* find(const FontWish& wish, char32_t letter = U' ');

 private:
  struct Library;

  std::unique_ptr<Library> library_;
  std::map<std::pair<std::string, int>, std::unique_ptr<Font>> fonts_;
  std::map<std::pair<FontWish, char32_t>, Font*> found_;
};

}  // namespace sim::text
