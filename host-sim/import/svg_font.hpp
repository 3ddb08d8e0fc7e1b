#pragma once

#include <string>

#include "host-sim/import/svg_attributes.hpp"
#include "host-sim/import/svg_cascade.hpp"
#include "host-sim/text/font.hpp"

namespace sim::drawing {

/// What letters inherit.
struct SvgFont {
  text::FontWish wish{};
  double letter_spacing = 0.0;  ///< Behind each letter, in user units.
  double word_spacing = 0.0;    ///< Behind each blank, in user units.
  std::string anchor = "start";
  std::string baseline{};  ///< `dominant-baseline`; empty: the usual one.
  bool keeps_blanks = false;
};

/// Takes font, spacing and size, `viewport.em`, of an element over what it inherits.
void inherit_font(const SvgProperties& properties, SvgViewport& viewport, SvgFont& font);

/// Returns how far the base line lies below the line that `baseline` names, in em.
[[nodiscard]] double base_line_shift(std::string_view baseline, const text::FontFigures& figures);

}  // namespace sim::drawing
