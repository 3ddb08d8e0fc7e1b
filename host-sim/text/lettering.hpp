#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/text/font.hpp"

namespace sim::text {

/// A glyph of a line, in em, with y upwards. Its origin is the position of the pen before the
/// glyph.
struct Letter {
  std::size_t byte = 0;  ///< Index, in the text, of the first byte that the glyph represents.
  double advance = 0.0;  ///< Distance by which the pen moves to the next glyph.
  Strokes strokes{};
};

/// Draws lines of letters as outlines of fonts of the system, or as single strokes of a built-in
/// font.
class Lettering {
 public:
  /// @param is_stroked true for single strokes; false for outlines
  explicit Lettering(bool is_stroked) : is_stroked_{is_stroked} {}

  /// Returns the glyphs of a line in UTF-8. Letters that no font has are left out, and missing()
  /// returns them.
  [[nodiscard]] std::vector<Letter> line(std::string_view words, const FontWish& wish);
  [[nodiscard]] FontFigures figures(const FontWish& wish);

  /// Returns the name of the font of the last line; empty if no font was used.
  [[nodiscard]] const std::string& font_name() const { return font_name_; }
  /// Returns the letters that were left out of the last line.
  [[nodiscard]] const std::string& missing() const { return missing_; }
  [[nodiscard]] bool is_stroked() const { return is_stroked_; }

 private:
  void outlines(std::string_view words, const FontWish& wish, std::vector<Letter>& letters);
  static void outlines_of(Font& font,
                          std::string_view words,
                          std::size_t from,
                          std::vector<Letter>& letters);
  void strokes(std::string_view words, std::vector<Letter>& letters);

  bool is_stroked_;
  FontBook fonts_;
  std::map<char32_t, Strokes> stroked_;
  std::string font_name_;
  std::string missing_;
};

}  // namespace sim::text
