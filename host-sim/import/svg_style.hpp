#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/clip_region.hpp"
#include "host-sim/import/drawing.hpp"
#include "host-sim/import/svg_attributes.hpp"
#include "host-sim/import/svg_cascade.hpp"
#include "host-sim/import/svg_font.hpp"

namespace sim::drawing {

/// The properties that an element passes on to the elements within it.
struct SvgStyle {
  Transform to_mm{};
  SvgViewport viewport{};
  std::string layer{};
  std::string stroke = "none";
  std::string fill = "black";
  std::string colour = "black";  ///< Colour that `currentColor` stands for.
  std::string stroke_width = "1";
  std::string stroke_opacity = "1";
  std::string fill_opacity = "1";
  std::string fill_rule = "nonzero";
  std::string clip_rule = "nonzero";
  SvgFont font{};
  ClipRegions clips{};
  bool is_visible = true;
  bool is_clear = false;  ///< True if the opacity of the element, or of an element around it, is 0.
  std::size_t depth = 0;

  /// Return whether outlines (has_stroke()) or areas (has_fill()) are painted in a visible colour.
  [[nodiscard]] bool has_stroke() const;
  [[nodiscard]] bool has_fill() const;
  /// Returns the colour by which the drawing is sorted into layers: the colour of the stroke or, if
  /// outlines are not painted, that of the fill.
  [[nodiscard]] const std::string& sorting_colour() const { return has_stroke() ? stroke : fill; }
};

/// Replaces inherited properties in `style` by those that an element gives.
void inherit(const SvgProperties& properties, SvgStyle& style);

/// Returns the rule that a value of `fill-rule` or `clip-rule` names.
[[nodiscard]] FillRule fill_rule_of(std::string_view value);

/// Returns the id in a text `url(#id)`, with or without quotes; empty if the text has another form.
[[nodiscard]] std::string_view svg_reference(std::string_view text);

}  // namespace sim::drawing
