#include "host-sim/import/svg_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "host-sim/import/letters.hpp"
#include "host-sim/import/scanner.hpp"
#include "host-sim/text/utf8.hpp"

namespace sim::drawing {
namespace {

constexpr double kDegreeOfText = kFullTurn / 360.0;
constexpr std::size_t kMaxCharacters = 100'000;

/// Returns the lengths in a list whose entries are separated by blanks or commas, up to the first
/// entry that is no length.
std::vector<double> lengths_of(std::string_view text,
                               const SvgViewport& viewport,
                               SvgDirection direction) {
  std::vector<double> lengths;
  while (!text.empty() && lengths.size() < kMaxCharacters) {
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t\r\n,")));
    const std::string_view one = text.substr(0, text.find_first_of(" \t\r\n,"));
    const auto length = svg_length(one, viewport, direction);
    if (!length) break;
    lengths.push_back(*length);
    text.remove_prefix(one.size());
  }
  return lengths;
}

}  // namespace

void SvgText::read(const pugi::xml_node& node, const SvgStyle& style) {
  spans_.clear();
  characters_.clear();
  pen_ = {0.0, 0.0};
  collect(node, style);
  while (!characters_.empty() && characters_.back().bytes == " " &&
         !spans_[characters_.back().span].style.font.keeps_blanks) {
    characters_.pop_back();
  }
  for (std::size_t i = 0; i < characters_.size();) i = lay_chunk(i);
}

// Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
void SvgText::collect(const pugi::xml_node& node, const SvgStyle& style) {
  const SvgProperties properties = document_.properties_of(node);
  note_unfollowed(node, properties);
  const std::size_t from = characters_.size();
  const std::size_t span = spans_.size();
  spans_.push_back({node, style});
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
      append(child.value(), span);
    } else if (child.type() == pugi::node_element) {
      collect_child(child, style);
    }
  }
  move_characters(properties, style.viewport, from);
}

// Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
void SvgText::collect_child(const pugi::xml_node& child, const SvgStyle& style) {
  const std::string_view name = local_name(child);
  if (name == "title" || name == "desc" || name == "metadata" || !document_.count(child)) return;
  const SvgProperties properties = document_.properties_of(child);
  if (properties.get("display") == "none") return;
  if (name != "tspan" && name != "a" && name != "altGlyph") {
    sketch_.note({FaultKind::kText,
                  document_.entity_of(child),
                  {},
                  fmt::format("letters in <{:.40}> are left out", name),
                  "convert them to paths in the drawing program"});
    return;
  }
  if (style.depth >= kDeepestNesting) {
    return document_.report_bad(
        child, fmt::format("nested deeper than {} elements", kDeepestNesting), "ungroup it");
  }
  SvgStyle inner = style;
  ++inner.depth;
  inherit(properties, inner);
  collect(child, inner);
}

void SvgText::append(std::string_view text, std::size_t span) {
  const bool keeps = spans_[span].style.font.keeps_blanks;
  while (!text.empty() && characters_.size() < kMaxCharacters) {
    const text::CodePoint letter = text::code_point(text);
    const bool blank = letter.size == 1 && kCssBlanks.find(text.front()) != std::string_view::npos;
    const bool follows = characters_.empty() || characters_.back().bytes == " ";
    if (!blank || keeps || !follows) {
      characters_.push_back({blank ? " " : std::string{text.substr(0, letter.size)}, span});
    }
    text.remove_prefix(letter.size);
  }
}

void SvgText::move_characters(const SvgProperties& properties,
                              const SvgViewport& viewport,
                              std::size_t from) {
  const std::size_t count = characters_.size() - from;
  const auto each = [&](const char* name, SvgDirection direction, const auto& take) {
    auto list = lengths_of(properties.attribute(name), viewport, direction);
    for (std::size_t i = 0; i < std::min(count, list.size()); ++i) {
      take(characters_[from + i], list[i]);
    }
    return list;
  };
  // Inner elements are processed before outer ones, and the values of inner elements take
  // precedence.
  const auto first = [](std::optional<double>& value, double given) {
    if (!value) value = given;
  };
  each("x", SvgDirection::kAcross, [&](Character& c, double value) { first(c.x, value); });
  each("y", SvgDirection::kUpright, [&](Character& c, double value) { first(c.y, value); });
  each("dx", SvgDirection::kAcross, [](Character& c, double value) { c.dx += value; });
  each("dy", SvgDirection::kUpright, [](Character& c, double value) { c.dy += value; });
  const auto turns = each("rotate", SvgDirection::kOther, [](Character&, double) {});
  for (std::size_t i = 0; i < count && !turns.empty(); ++i) {
    double& own = characters_[from + i].rotate_deg;
    if (own == 0.0) own = turns[std::min(i, turns.size() - 1)];
  }
}

void SvgText::note_unfollowed(const pugi::xml_node& node, const SvgProperties& properties) {
  static constexpr std::array<const char*, 6> kNames{"textLength",
                                                     "baseline-shift",
                                                     "text-decoration",
                                                     "writing-mode",
                                                     "font-variant",
                                                     "text-transform"};
  for (const char* const name : kNames) {
    const std::string_view value = properties.get(name);
    static constexpr std::array<std::string_view, 9> kUsual{
        "", "normal", "none", "baseline", "0", "0px", "lr", "lr-tb", "horizontal-tb"};
    if (std::ranges::find(kUsual, value) != kUsual.end() || value.starts_with("none ")) continue;
    sketch_.note({FaultKind::kText,
                  document_.entity_of(node),
                  {},
                  fmt::format("{} of letters is ignored", name),
                  "check them in the picture of --svg, or convert them to paths"});
  }
}

std::size_t SvgText::lay_chunk(std::size_t from) {
  pen_ = {characters_[from].x.value_or(pen_.x()), characters_[from].y.value_or(pen_.y())};
  std::size_t to = from + 1;
  while (to < characters_.size() && !characters_[to].x && !characters_[to].y) ++to;
  // The blanks at the end of a line separate it from the next line and belong to neither of them.
  std::size_t end = to;
  while (to < characters_.size() && end > from + 1 && characters_[end - 1].bytes == " ") --end;
  const double start = pen_.x();
  std::vector<Glyph> glyphs;
  for (std::size_t i = from; i < end;) {
    std::size_t next = i + 1;
    while (next < end && characters_[next].span == characters_[i].span) ++next;
    lay_run(i, next, glyphs);
    i = next;
  }
  const std::string& anchor = spans_[characters_[from].span].style.font.anchor;
  const double width = pen_.x() - start;
  const double shift = anchor == "middle" ? -0.5 * width : anchor == "end" ? -width : 0.0;
  pen_.x() += shift;
  draw(glyphs, shift);
  return to;
}

void SvgText::lay_run(std::size_t from, std::size_t to, std::vector<Glyph>& glyphs) {
  const Span& span = spans_[characters_[from].span];
  const SvgFont& font = span.style.font;
  const double em = span.style.viewport.em;
  std::string words;
  std::vector<std::size_t> begins;
  for (std::size_t i = from; i < to; ++i) {
    begins.push_back(words.size());
    words += characters_[i].bytes;
  }
  text::Lettering& lettering = sketch_.lettering();
  const std::vector<text::Letter> letters = lettering.line(words, font.wish);
  Entity entity = document_.entity_of(span.node);
  entity.layer = sketch_.layer({span.style.layer, span.style.sorting_colour()});
  sort_letters(sketch_, entity);
  if (span.style.is_visible) note_font(sketch_, entity, words);
  const double below = base_line_shift(font.baseline, lettering.figures(font.wish)) * em;
  std::size_t moved = from;
  for (const text::Letter& letter : letters) {
    const auto after = std::ranges::upper_bound(begins, letter.byte);
    const std::size_t index = from + static_cast<std::size_t>(after - begins.begin()) - 1;
    for (; moved <= index; ++moved) pen_ += Place{characters_[moved].dx, characters_[moved].dy};
    glyphs.push_back({characters_[from].span,
                      letter.strokes,
                      pen_ + Place{0.0, below},
                      characters_[index].rotate_deg});
    pen_.x() += letter.advance * em + font.letter_spacing;
    if (characters_[index].bytes == " ") pen_.x() += font.word_spacing;
  }
}

void SvgText::draw(const std::vector<Glyph>& glyphs, double shift) {
  for (const Glyph& glyph : glyphs) {
    const Span& span = spans_[glyph.span];
    if (!span.style.is_visible || glyph.strokes.empty()) continue;
    const double em = span.style.viewport.em;
    const Transform to_mm = span.style.to_mm * moved_by(glyph.at + Place{shift, 0.0}) *
                            turned_by(glyph.rotate_deg * kDegreeOfText) * scaled_by(em, -em);
    text::Strokes strokes = glyph.strokes;
    for (std::vector<Shape>& shapes : strokes) {
      for (Shape& shape : shapes) shape = transformed(shape, to_mm);
    }
    clips_.keep_visible(span.node, span.style, strokes);
    Entity entity = document_.entity_of(span.node);
    entity.layer = sketch_.layer({span.style.layer, span.style.sorting_colour()});
    sort_letters(sketch_, entity);
    if (!add_letter_curves(sketch_, entity, std::move(strokes))) return;
  }
}

}  // namespace sim::drawing
