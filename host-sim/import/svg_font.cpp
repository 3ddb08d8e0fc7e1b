#include "host-sim/import/svg_font.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "host-sim/import/scanner.hpp"

namespace sim::drawing {
namespace {

constexpr unsigned kNormalWeight = 400;
constexpr unsigned kBoldWeight = 700;

void take_size(std::string_view text, SvgViewport& viewport) {
  if (text.ends_with('%')) {
    if (const auto percent = Scanner{text}.number()) viewport.em *= 0.01 * *percent;
    return;
  }
  static constexpr std::array<std::pair<std::string_view, double>, 7> kNamed{{{"xx-small", 9.6},
                                                                              {"x-small", 12.0},
                                                                              {"small", 14.2},
                                                                              {"medium", 16.0},
                                                                              {"large", 19.2},
                                                                              {"x-large", 24.0},
                                                                              {"xx-large", 32.0}}};
  const auto* const named = std::ranges::find(kNamed, text, [](const auto& n) { return n.first; });
  if (named != kNamed.end()) {
    viewport.em = named->second;
  } else if (const auto size = svg_length(text, viewport, SvgDirection::kOther)) {
    viewport.em = std::max(0.0, *size);
  }
}

/// Sets the weight of the font if a word is a weight. Returns whether it is one.
bool take_weight(std::string_view word, text::FontWish& wish) {
  if (word == "bold") {
    wish.weight = kBoldWeight;
  } else if (word == "normal") {
    wish.weight = kNormalWeight;
  } else if (word == "bolder" || word == "lighter") {
    wish.weight = word == "bolder" ? std::max(wish.weight + 300, kBoldWeight) : 300;
  } else if (const auto number = Scanner{word}.number();
             number && *number >= 1.0 && *number <= 1000.0) {
    wish.weight = static_cast<unsigned>(*number);
  } else {
    return false;
  }
  return true;
}

bool take_slant(std::string_view word, text::FontWish& wish) {
  const bool slanted = word.starts_with("italic") || word.starts_with("oblique");
  if (!slanted && word != "normal") return false;
  wish.is_slanted = slanted;
  return true;
}

/// Reads the value of the shorthand property `font`, for example `italic bold 12px/1.5 Georgia,
/// serif`.
void take_shorthand(std::string_view text, SvgViewport& viewport, text::FontWish& wish) {
  if (text.empty() || text == "inherit") return;
  wish.weight = kNormalWeight;
  wish.is_slanted = false;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find_first_of(kCssBlanks));
    text = css_trimmed(text.substr(word.size()));
    const bool is_size = word.find_first_of("0123456789") == 0 && !text.empty() &&
                         word.find_first_not_of("0123456789") != std::string_view::npos;
    if (is_size) {
      take_size(word.substr(0, word.find('/')), viewport);
      wish.family = text;
      return;
    }
    if (!take_slant(word, wish)) take_weight(word, wish);
  }
}

void take_spacing(std::string_view text, const SvgViewport& viewport, double& spacing) {
  if (text == "normal") spacing = 0.0;
  const auto length = svg_length(text, viewport, SvgDirection::kOther);
  if (length) spacing = *length;
}

}  // namespace

void inherit_font(const SvgProperties& properties, SvgViewport& viewport, SvgFont& font) {
  const auto given = [](std::string_view value) { return !value.empty() && value != "inherit"; };
  take_shorthand(properties.styled("font"), viewport, font.wish);
  const std::string_view size = properties.get("font-size");
  if (given(size)) take_size(size, viewport);
  const std::string_view family = properties.get("font-family");
  if (given(family)) font.wish.family = family;
  const std::string_view weight = properties.get("font-weight");
  if (given(weight)) take_weight(weight, font.wish);
  const std::string_view slant = properties.get("font-style");
  if (given(slant)) take_slant(slant, font.wish);
  take_spacing(properties.get("letter-spacing"), viewport, font.letter_spacing);
  take_spacing(properties.get("word-spacing"), viewport, font.word_spacing);
  const std::string_view anchor = properties.get("text-anchor");
  if (given(anchor)) font.anchor = anchor;
  for (const char* const name : {"dominant-baseline", "alignment-baseline"}) {
    const std::string_view baseline = properties.get(name);
    if (given(baseline)) font.baseline = baseline;
  }
  const std::string_view blanks = properties.get("white-space");
  if (given(blanks)) font.keeps_blanks = blanks.starts_with("pre") && blanks != "pre-line";
  const std::string_view space = properties.attribute("xml:space");
  if (!space.empty()) font.keeps_blanks = space == "preserve";
}

double base_line_shift(std::string_view baseline, const text::FontFigures& figures) {
  if (baseline == "hanging") return 0.8 * figures.ascent;
  if (baseline == "middle") return 0.5 * figures.small;
  if (baseline == "central") return 0.5 * (figures.ascent - figures.descent);
  if (baseline == "mathematical") return 0.5 * figures.ascent;
  if (baseline == "text-before-edge" || baseline == "before-edge" || baseline == "text-top") {
    return figures.ascent;
  }
  const bool below = baseline == "text-after-edge" || baseline == "after-edge" ||
                     baseline == "text-bottom" || baseline == "ideographic";
  return below ? -figures.descent : 0.0;
}

}  // namespace sim::drawing
