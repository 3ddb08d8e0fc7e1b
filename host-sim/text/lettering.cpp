#include "host-sim/text/lettering.hpp"

#include <algorithm>

#include "host-sim/import/svg_path.hpp"
#include "host-sim/text/stroke_font.hpp"
#include "host-sim/text/utf8.hpp"

namespace sim::text {
namespace {

using drawing::Place;
using drawing::Transform;

Strokes transformed(const Strokes& strokes, const Transform& transform) {
  Strokes result = strokes;
  for (auto& shapes : result) {
    for (drawing::Shape& shape : shapes) shape = drawing::transformed(shape, transform);
  }
  return result;
}

/// Returns whether a letter has no ink, so that it needs no glyph.
bool is_blank(char32_t letter) {
  return letter == U' ' || letter == U'\u00A0' || (letter >= 0x2000 && letter <= 0x200F) ||
         letter == 0xFEFF || letter == 0x00AD || letter < U' ';
}

/// Returns the strokes of a letter of the built-in stroke font, in em.
Strokes stroked(const StrokeGlyph& glyph) {
  drawing::SvgPen pen;
  static_cast<void>(drawing::draw_path(glyph.path, pen));
  const double scale = 1.0 / kStrokeUnitsPerEm;
  return transformed(pen.subpaths(),
                     drawing::scaled_by(scale, scale) * drawing::moved_by({kStrokeBearing, 0.0}));
}

}  // namespace

std::vector<Letter> Lettering::line(std::string_view words, const FontWish& wish) {
  missing_.clear();
  std::vector<Letter> letters;
  if (is_stroked_) {
    strokes(words, letters);
  } else {
    outlines(words, wish, letters);
  }
  return letters;
}

void Lettering::strokes(std::string_view words, std::vector<Letter>& letters) {
  font_name_ = "single strokes";
  for (std::size_t at = 0; at < words.size();) {
    const CodePoint letter = code_point(words.substr(at));
    const auto glyph = stroke_glyph(is_blank(letter.value) ? U' ' : letter.value);
    if (glyph) {
      const auto [found, is_new] = stroked_.try_emplace(letter.value);
      if (is_new) found->second = stroked(*glyph);
      const double advance = (glyph->width + 2.0 * kStrokeBearing) / kStrokeUnitsPerEm;
      letters.push_back({at, advance, found->second});
    } else {
      missing_ += words.substr(at, letter.size);
    }
    at += letter.size;
  }
}

void Lettering::outlines(std::string_view words,
                         const FontWish& wish,
                         std::vector<Letter>& letters) {
  Font* const usual = fonts_.find(wish);
  font_name_ = usual == nullptr ? std::string{} : usual->name();
  std::size_t from = 0;
  Font* font = nullptr;
  for (std::size_t at = 0; at < words.size();) {
    const CodePoint letter = code_point(words.substr(at));
    Font* own = usual;
    if (own != nullptr && !own->has(letter.value) && !is_blank(letter.value)) {
      own = fonts_.find(wish, letter.value);
      if (own != nullptr && !own->has(letter.value)) own = nullptr;
    }
    if (own == nullptr) missing_ += words.substr(at, letter.size);
    if (own != font) {
      if (font != nullptr) outlines_of(*font, words.substr(from, at - from), from, letters);
      from = at;
      font = own;
    }
    at += letter.size;
  }
  if (font != nullptr) outlines_of(*font, words.substr(from), from, letters);
}

void Lettering::outlines_of(Font& font,
                            std::string_view words,
                            std::size_t from,
                            std::vector<Letter>& letters) {
  for (const PlacedGlyph& placed : font.shape(words)) {
    Letter letter{from + placed.byte, placed.advance, {}};
    const std::string_view rest = words.substr(std::min(words.size(), placed.byte));
    const bool blank = !rest.empty() && is_blank(code_point(rest).value);
    if (!blank) {
      letter.strokes = transformed(font.outline(placed.glyph), drawing::moved_by(placed.offset));
    }
    letters.push_back(std::move(letter));
  }
}

FontFigures Lettering::figures(const FontWish& wish) {
  if (is_stroked_) {
    return {.ascent = 11.0 / kStrokeUnitsPerEm,
            .descent = kStrokeDescent / kStrokeUnitsPerEm,
            .capital = kStrokeCapital / kStrokeUnitsPerEm,
            .small = kStrokeSmall / kStrokeUnitsPerEm};
  }
  Font* const font = fonts_.find(wish);
  return font == nullptr ? FontFigures{} : font->figures();
}

}  // namespace sim::text
