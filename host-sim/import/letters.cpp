#include "host-sim/import/letters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "host-sim/import/stroke_colour.hpp"

namespace sim::drawing {
namespace {

/// Returns whether a text has letters that are read from right to left.
bool has_right_to_left(std::string_view words) {
  // The UTF-8 codes of U+0590 to U+08FF begin with the bytes below.
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    const auto byte = static_cast<unsigned char>(words[i]);
    const auto next = static_cast<unsigned char>(words[i + 1]);
    if ((byte >= 0xD6U && byte <= 0xDFU) || (byte == 0xE0U && next >= 0xA0U && next <= 0xA3U)) {
      return true;
    }
  }
  return false;
}

double em_of(const LetterLine& line, text::Lettering& lettering) {
  return line.is_capital_height ? line.size / lettering.figures(line.font).capital : line.size;
}

}  // namespace

void note_font(Sketch& sketch, const Entity& entity, std::string_view words) {
  const text::Lettering& lettering = sketch.lettering();
  if (lettering.font_name().empty()) {
    return sketch.note({FaultKind::kText,
                        entity,
                        {},
                        "letters are left out: this system has no scalable font",
                        "install a font, or use --text stroke"});
  }
  sketch.note({FaultKind::kText,
               entity,
               {},
               fmt::format("letters are drawn in {}", lettering.font_name()),
               {}},
              fmt::format(": \"{}\"", first_words(words)));
  if (!lettering.missing().empty()) {
    sketch.note({FaultKind::kText,
                 entity,
                 {},
                 fmt::format("letters that {} does not have are left out", lettering.font_name()),
                 "convert them to paths in the drawing program"},
                fmt::format(": \"{}\"", first_words(lettering.missing())));
  }
  if (has_right_to_left(words)) {
    sketch.note({FaultKind::kText,
                 entity,
                 {},
                 "letters of a right-to-left script may be in the wrong order",
                 "check them in the picture of --svg, or convert them to paths"});
  }
}

void sort_letters(Sketch& sketch, Entity& entity) {
  entity.fill_rule = FillRule::kNonZero;
  entity.is_filled = sketch.text() == TextMode::kOutline;
  if (sketch.text() != TextMode::kStroke) return;
  entity.layer = sketch.layer(
      {.name = sketch.layers()[entity.layer].name, .colour = std::string{kStrokeTextColour}});
}

bool add_letter_curves(Sketch& sketch, const Entity& entity, text::Strokes strokes) {
  if (strokes.empty()) return true;
  const std::size_t index = sketch.add_entity(entity);
  for (std::vector<Shape>& shapes : strokes) {
    if (!sketch.add({std::move(shapes), index})) return false;
  }
  return true;
}

double width_of(const LetterLine& line, text::Lettering& lettering) {
  double width_em = 0.0;
  for (const text::Letter& letter : lettering.line(line.words, line.font)) {
    width_em += letter.advance + line.spacing_em;
  }
  return width_em * em_of(line, lettering) * line.stretch;
}

void add_letters(Sketch& sketch,
                 Entity entity,
                 const LetterLine& line,
                 const std::function<bool(const std::vector<Shape>&)>& is_visible) {
  if (sketch.text() == TextMode::kSkip) return sketch.leave_out_text(entity, line.words);
  sort_letters(sketch, entity);
  text::Lettering& lettering = sketch.lettering();
  const std::vector<text::Letter> letters = lettering.line(line.words, line.font);
  note_font(sketch, entity, line.words);
  double width_em = 0.0;
  for (const text::Letter& letter : letters) width_em += letter.advance + line.spacing_em;
  const double share = line.anchor == TextAnchor::kStart    ? 0.0
                       : line.anchor == TextAnchor::kMiddle ? 0.5
                                                            : 1.0;
  const double em = em_of(line, lettering);
  const Transform slanted{{line.stretch, 0.0}, {std::tan(line.slant_rad), 1.0}, {0.0, 0.0}};
  const Transform to_mm = line.to_mm * scaled_by(em, em) * slanted;
  double pen = -share * width_em;
  for (const text::Letter& letter : letters) {
    text::Strokes strokes = letter.strokes;
    for (std::vector<Shape>& shapes : strokes) {
      for (Shape& shape : shapes) shape = transformed(shape, to_mm * moved_by({pen, 0.0}));
    }
    pen += letter.advance + line.spacing_em;
    if (is_visible) {
      std::erase_if(strokes, [&](const std::vector<Shape>& row) { return !is_visible(row); });
    }
    if (!add_letter_curves(sketch, entity, std::move(strokes))) return;
  }
}

}  // namespace sim::drawing
