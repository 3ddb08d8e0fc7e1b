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
  std::string words{};  ///< UTF-8, without line breaks.
  text::FontWish font{};
  double size = 1.0;               ///< Size of the em, in units of the line's axes.
  bool is_capital_height = false;  ///< The size is the height of capital letters, not of the em.
  double stretch = 1.0;            ///< Factor of the width.
  double slant_rad = 0.0;          ///< Lean of upright strokes, to the right.
  double spacing_em = 0.0;         ///< Extra distance after each letter, in em.
  TextAnchor anchor = TextAnchor::kStart;
  /// Maps the axes of the line to mm: the base line is along x, the origin is the anchor, y points
  /// upwards.
  Transform to_mm{};
};

/// Returns the width of a line in the unit of its size; `to_mm` does not affect it.
[[nodiscard]] double width_of(const LetterLine& line, text::Lettering& lettering);

/// Draws a line of letters in the text mode of the sketch: as outlines, as single strokes, or not
/// at all. A note names the font, or says that the letters are left out.
/// @param entity entity with the layer of the letters
/// @param is_visible returns whether a row of curves, in mm, is drawn; empty: all rows are drawn
void add_letters(Sketch& sketch,
                 Entity entity,
                 const LetterLine& line,
                 const std::function<bool(const std::vector<Shape>&)>& is_visible = {});

/// Gives letters of single strokes a colour of their own, kStrokeTextColour.
void sort_letters(Sketch& sketch, Entity& entity);

/// Adds curves of letters, in mm. Returns false if there are too many.
bool add_letter_curves(Sketch& sketch, const Entity& entity, text::Strokes strokes);

/// Adds notes: the font of the last line, and the letters that no font has.
void note_font(Sketch& sketch, const Entity& entity, std::string_view words);

}  // namespace sim::drawing
