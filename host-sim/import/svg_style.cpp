#include "host-sim/import/svg_style.hpp"

#include <algorithm>
#include <array>

#include "host-sim/import/scanner.hpp"

namespace sim::drawing {
namespace {

/// Returns whether a text is a number or a percentage that is at most 0.
bool is_nothing(std::string_view text) {
  const auto value = Scanner{text}.number();
  return value && *value <= 0.0;
}

/// Returns whether a paint is a visible colour, or refers to a pattern.
bool is_paint(std::string_view paint) {
  if (paint == "none" || paint == "transparent") return false;
  if (paint.starts_with("rgba(") || paint.starts_with("hsla(")) {
    const std::size_t comma = paint.rfind(',');
    return comma == std::string_view::npos || !is_nothing(paint.substr(comma + 1));
  }
  if (!paint.starts_with('#')) return true;
  return !(paint.size() == 5 && paint.ends_with('0')) &&
         !(paint.size() == 9 && paint.ends_with("00"));
}

struct Inherited {
  const char* name;
  std::string SvgStyle::*value;
};

constexpr std::array<Inherited, 8> kInherited{{{"stroke", &SvgStyle::stroke},
                                               {"fill", &SvgStyle::fill},
                                               {"color", &SvgStyle::colour},
                                               {"stroke-width", &SvgStyle::stroke_width},
                                               {"stroke-opacity", &SvgStyle::stroke_opacity},
                                               {"fill-opacity", &SvgStyle::fill_opacity},
                                               {"fill-rule", &SvgStyle::fill_rule},
                                               {"clip-rule", &SvgStyle::clip_rule}}};

}  // namespace

bool SvgStyle::has_stroke() const {
  return is_paint(stroke) && !is_nothing(stroke_opacity) && !is_nothing(stroke_width);
}

bool SvgStyle::has_fill() const { return is_paint(fill) && !is_nothing(fill_opacity); }

void inherit(const SvgProperties& properties, SvgStyle& style) {
  const SvgStyle initial;
  for (const Inherited& property : kInherited) {
    const std::string_view value = properties.get(property.name);
    if (value.empty() || value == "inherit" || value == "unset") continue;
    style.*property.value = value == "initial" ? initial.*property.value : std::string{value};
  }
  for (std::string* const paint : {&style.stroke, &style.fill}) {
    if (*paint == "currentColor" || *paint == "currentcolor") *paint = style.colour;
  }
  const std::string_view visibility = properties.get("visibility");
  if (!visibility.empty() && visibility != "inherit") style.is_visible = visibility == "visible";
  style.is_clear = style.is_clear || is_nothing(properties.get("opacity"));
  inherit_font(properties, style.viewport, style.font);
}

FillRule fill_rule_of(std::string_view value) {
  return value == "evenodd" ? FillRule::kEvenOdd : FillRule::kNonZero;
}

std::string_view svg_reference(std::string_view text) {
  if (!text.starts_with("url(")) return {};
  text = text.substr(4, text.find(')') == std::string_view::npos ? 0 : text.find(')') - 4);
  text = css_trimmed(text);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'')) {
    text = text.substr(1, text.size() - 2);
  }
  if (!text.starts_with('#')) return {};
  return text.substr(1);
}

}  // namespace sim::drawing
