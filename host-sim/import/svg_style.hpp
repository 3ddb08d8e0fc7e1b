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

/// Properties that elements hand down to those within them.
struct SvgStyle {
  Transform to_mm{};
  SvgViewport viewport{};
  std::string layer{};
  std::string stroke = "none";
  std::string fill = "black";
  std::string colour = "black";  ///< Meant by `currentColor`.
  std::string stroke_width = "1";
  std::string stroke_opacity = "1";
  std::string fill_opacity = "1";
  std::string fill_rule = "nonzero";
  std::string clip_rule = "nonzero";
  SvgFont font{};
  ClipRegions clips{};
  bool is_visible = true;
  bool is_clear = false;  ///< Opacity 0, of its own or of an element around it.
  std::size_t depth = 0;

  /// Returns whether outlines, or areas, are painted in a colour that is seen.
  [[nodiscard]] bool has_stroke() const;
  [[nodiscard]] bool has_fill() const;
  /// Returns the colour that sorts a drawing: of the stroke, else of the fill.
  [[nodiscard]] const std::string& sorting_colour() const { return has_stroke() ? stroke : fill; }
};

/// Takes what an element says over what it inherits.
void inherit(const SvgProperties& properties, SvgStyle& style);

/// Returns the rule that a value of `fill-rule` or `clip-rule` names.
[[nodiscard]] FillRule fill_rule_of(std::string_view value);

/// Returns the id of `url(#id)`, with or without quotes; empty where the text is none.
[[nodiscard]] std::string_view svg_reference(std::string_view text);

}  // namespace sim::drawing
