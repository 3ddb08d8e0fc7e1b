#pragma once

#include <string>

#include "host-sim/import/svg_attributes.hpp"
#include "host-sim/import/svg_cascade.hpp"
#include "host-sim/text/font.hpp"

namespace sim::drawing {

/// Properties of letters, which elements inherit.
struct SvgFont {
  text::FontWish wish{};
  double letter_spacing = 0.0;  ///< Additional distance after each letter, in user units.
  double word_spacing = 0.0;    ///< Additional distance after each blank, in user units.
  std::string anchor = "start";
  std::string baseline{};  ///< Value of `dominant-baseline`; empty for the default base line.
  bool keeps_blanks = false;
};

/// Replaces the inherited font, spacing and size (`viewport.em`) by the values that an element
/// gives.
void inherit_font(const SvgProperties& properties, SvgViewport& viewport, SvgFont& font);

/// Returns the distance of the base line below the line that `baseline` names, in em.
[[nodiscard]] double base_line_shift(std::string_view baseline, const text::FontFigures& figures);

}  // namespace sim::drawing
