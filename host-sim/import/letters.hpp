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

/// A line of letters as a drawing has it.
struct LetterLine {
  std::string words{};  ///< UTF-8, without line breaks.
  text::FontWish font{};
  double size = 1.0;               ///< Size of the em.
  bool is_capital_height = false;  ///< The size is that of capital letters instead.
  double stretch = 1.0;            ///< Factor of the width.
  double slant_rad = 0.0;          ///< Lean of upright strokes, to the right.
  double spacing_em = 0.0;         ///< Behind each letter.
  TextAnchor anchor = TextAnchor::kStart;
  Transform to_mm{};  ///< Base line along x, through the origin at the anchor, y upwards.
};

/// Returns the width of a line in the unit of its size, whatever its `to_mm`.
[[nodiscard]] double width_of(const LetterLine& line, text::Lettering& lettering);

/// Draws a line of letters as the sketch wishes: outlines, single strokes, or nothing. A note has
/// the font, or that they are left out.
/// @param entity with the layer of the letters
/// @param is_visible tells of each row of curves, in mm, whether it is drawn; all where it is empty
void add_letters(Sketch& sketch,
                 Entity entity,
                 const LetterLine& line,
                 const std::function<bool(const std::vector<Shape>&)>& is_visible = {});

/// Sorts letters of single strokes by a colour of their own, kStrokeTextColour.
void sort_letters(Sketch& sketch, Entity& entity);

/// Adds curves of letters, in mm. False when there are too many.
bool add_letter_curves(Sketch& sketch, const Entity& entity, text::Strokes strokes);

/// Notes the font of the last line, and letters that no font has.
void note_font(Sketch& sketch, const Entity& entity, std::string_view words);

}  // namespace sim::drawing
