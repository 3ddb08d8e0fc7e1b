#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/place.hpp"
#include "host-sim/import/sketch.hpp"
#include "host-sim/text/lettering.hpp"

namespace sim::drawing {

enum class TextAnchor : std::uint8_t { kStart, kMiddle, kEnd };

/// A line of letters of a drawing.
struct LetterLine {
  std::string words{};  ///< Text of the line in UTF-8, without line breaks.
  text::FontWish font{};
  double size = 1.0;  ///< Size of the em, in units of the line's axes.
  /// True if `size` is the height of capital letters; false if it is the size of the em.
  bool is_capital_height = false;
  double stretch = 1.0;     ///< Factor by which the width of letters is multiplied.
  double slant_rad = 0.0;   ///< Angle by which upright strokes lean to the right.
  double spacing_em = 0.0;  ///< Additional distance after each letter, in em.
  TextAnchor anchor = TextAnchor::kStart;
  /// Maps the axes of the line to mm. In these axes the base line is along x, the anchor is at the
  /// origin, and y points upwards.
  Transform to_mm{};
};

/// Returns the width of a line in the unit of LetterLine::size. LetterLine::to_mm does not affect
/// it.
[[nodiscard]] double width_of(const LetterLine& line, text::Lettering& lettering);

/// Draws a line of letters in the text mode of the sketch: as outlines, as single strokes, or not
/// at all. A note names the font, or reports that the letters are left out.
/// @param entity entity with the layer of the letters
/// @param is_visible returns whether a row of curves, in mm, is drawn; empty: all rows are drawn
void add_letters(Sketch& sketch,
                 Entity entity,
                 const LetterLine& line,
                 const std::function<bool(const std::vector<Shape>&)>& is_visible = {});

/// Sets fill rule and filling of the entity of letters. Puts letters of single strokes on another
/// layer, which has the same name but the colour kStrokeTextColour.
void sort_letters(Sketch& sketch, Entity& entity);

/// Adds the curves of letters, in mm, to the sketch. Returns false if the sketch cannot take more
/// curves.
bool add_letter_curves(Sketch& sketch, const Entity& entity, text::Strokes strokes);

/// Adds a note that names the font of the last line, and a note about letters that no font has.
void note_font(Sketch& sketch, const Entity& entity, std::string_view words);

}  // namespace sim::drawing
