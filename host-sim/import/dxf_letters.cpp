#include "host-sim/import/dxf_letters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "host-sim/import/dxf_mtext.hpp"
#include "host-sim/import/dxf_shapes.hpp"

namespace sim::drawing {
namespace {

constexpr double kDegreeOfLetters = kFullTurn / 360.0;
/// Distance between neighbouring base lines, in units of the height of capitals.
constexpr double kLineStep = 5.0 / 3.0;
constexpr const char* kNoHeight = "its height is not above 0";

/// Horizontal alignment of a TEXT at its point, as in group 72.
enum class Across : std::uint8_t { kLeft, kCentre, kRight, kAligned, kMiddle, kFit };

LetterLine line_in(const DxfEntity& entity, const DxfStyle& style) {
  return {.font = style.font,
          .size = entity.number(40, style.height),
          .is_capital_height = true,
          .stretch = entity.number(41, style.width),
          .slant_rad = entity.number(51, style.oblique_deg) * kDegreeOfLetters};
}

/// Makes a line of letters as wide as `length`. If `keeps_height` is true, changes only the width
/// of the letters, otherwise their size.
void fit(LetterLine& line, double length, bool keeps_height, text::Lettering& lettering) {
  const double width = width_of(line, lettering);
  if (!(width > 0.0) || !(length > 0.0)) return;
  (keeps_height ? line.stretch : line.size) *= length / width;
}

/// Returns the vertical alignment, which is group 73 of a TEXT and group 74 of an attribute.
int upright_of(const DxfEntity& entity) { return entity.whole(entity.type == "TEXT" ? 73 : 74, 0); }

/// Returns the height of the base line above the point of a TEXT, in units of the drawing.
double base_line_of(const DxfEntity& entity, const LetterLine& line, text::Lettering& lettering) {
  constexpr int kBottom = 1;
  constexpr int kMiddle = 2;
  constexpr int kTop = 3;
  const int upright = upright_of(entity);
  const bool is_middle = upright == 0 && entity.whole(72, 0) == static_cast<int>(Across::kMiddle);
  if (upright == kTop) return -line.size;
  if (upright == kMiddle || is_middle) return -0.5 * line.size;
  if (upright != kBottom) return 0.0;
  const text::FontFigures figures = lettering.figures(line.font);
  return line.size * figures.descent / figures.capital;
}

/// Returns the mirroring that the flags of group 71 require. Both a TEXT and its style may have
/// these flags.
Transform mirrored(int flags) {
  constexpr int kBackwards = 2;
  constexpr int kUpsideDown = 4;
  return scaled_by((flags & kBackwards) != 0 ? -1.0 : 1.0, (flags & kUpsideDown) != 0 ? -1.0 : 1.0);
}

DxfLetters text_line(const DxfEntity& entity, const DxfStyle& style, text::Lettering& lettering) {
  DxfLetters letters;
  LetterLine line = line_in(entity, style);
  if (!(line.size > 0.0)) return {.wrong = kNoHeight};
  const auto plane = dxf_plane(entity, entity.number(30, 0.0));
  if (!plane) return {.wrong = kDxfUpright};
  if (plane->is_tilted) letters.notes.emplace_back(kDxfSeenFromAbove);
  const DxfWords words = dxf_words(entity.text(entity.type == "ATTDEF" ? 2 : 1));
  line.words = words.text;
  if (words.has_unknown) {
    letters.notes.emplace_back("has characters (%%nnn) that are not in ASCII: they are left out");
  }
  if (words.has_lines)
    letters.notes.emplace_back("has lines under or over its letters: they are left out");
  const auto across = static_cast<Across>(std::clamp(entity.whole(72, 0), 0, 5));
  const bool is_between = across == Across::kAligned || across == Across::kFit;
  const double base_line = base_line_of(entity, line, lettering);
  const bool has_second = entity.number(11).has_value();
  const bool is_plain = across == Across::kLeft && upright_of(entity) == 0;
  const bool is_at_first = is_between || !has_second || is_plain;
  double angle = entity.number(50, 0.0) * kDegreeOfLetters;
  if (is_between && has_second) {
    const Place way = entity.place(11) - entity.place(10);
    angle = std::atan2(way.y(), way.x());
    fit(line, way.norm(), across == Across::kFit, lettering);
  }
  if (across == Across::kCentre || across == Across::kMiddle) line.anchor = TextAnchor::kMiddle;
  if (across == Across::kRight) line.anchor = TextAnchor::kEnd;
  line.to_mm = plane->to_plan * moved_by(entity.place(is_at_first ? 10 : 11)) * turned_by(angle) *
               mirrored(entity.whole(71, style.flags)) * moved_by({0.0, base_line});
  letters.lines.push_back(std::move(line));
  return letters;
}

/// Returns the angle of the base line in the plane of a MTEXT, radians. Group 11 may give the angle
/// as a direction in the plane of the drawing.
double angle_of(const DxfEntity& entity, const Transform& to_plan) {
  if (!entity.number(11)) return entity.number(50, 0.0) * kDegreeOfLetters;
  const Place way = entity.place(11);
  const double turn = cross(to_plan.x_axis, to_plan.y_axis);
  const Place own{cross(way, to_plan.y_axis) / turn, cross(to_plan.x_axis, way) / turn};
  return std::atan2(own.y(), own.x());
}

/// Returns the lines of paragraphs. Paragraphs that are wider than `width` are broken into lines at
/// blanks.
std::vector<std::string> wrapped_at(const std::vector<std::string>& paragraphs,
                                    double width,
                                    const LetterLine& like,
                                    text::Lettering& lettering) {
  if (!(width > 0.0)) return paragraphs;
  const auto measured = [&](const std::string& words) {
    LetterLine line = like;
    line.words = words;
    return width_of(line, lettering);
  };
  const double blank_width = measured(" ");
  std::vector<std::string> lines;
  for (const std::string& paragraph : paragraphs) {
    std::string line;
    double line_width = 0.0;
    for (std::size_t from = 0; from <= paragraph.size();) {
      const std::size_t to = std::min(paragraph.find(' ', from), paragraph.size());
      const std::string word = paragraph.substr(from, to - from);
      const double word_width = measured(word);
      const double with_word = line_width + (from == 0 ? 0.0 : blank_width) + word_width;
      const bool fits = from == 0 || with_word <= width;
      if (!fits) lines.push_back(std::exchange(line, {}));
      if (fits && from != 0) line += ' ';
      line += word;
      line_width = fits ? with_word : word_width;
      from = to + 1;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

DxfLetters paragraphs(const DxfEntity& entity, const DxfStyle& style, text::Lettering& lettering) {
  DxfLetters letters;
  const auto plane = dxf_plane(entity, entity.number(30, 0.0));
  if (!plane) return {.wrong = kDxfUpright};
  if (plane->is_tilted) letters.notes.emplace_back(kDxfSeenFromAbove);
  LetterLine like = line_in(entity, style);
  like.stretch = style.width;
  like.slant_rad = style.oblique_deg * kDegreeOfLetters;
  const MtextWords words = mtext_words(entity, like);
  if (!words.unfollowed.empty()) {
    letters.notes.push_back("has format codes that are ignored: " + words.unfollowed);
  }
  if (!(like.size > 0.0)) return {.wrong = kNoHeight};
  const auto lines = wrapped_at(words.paragraphs, entity.number(41, 0.0), like, lettering);
  const int attachment = std::clamp(entity.whole(71, 1), 1, 9) - 1;
  like.anchor = static_cast<TextAnchor>(attachment % 3);
  const double step = kLineStep * like.size * entity.number(44, 1.0);
  const double height = like.size + step * static_cast<double>(lines.size() - 1);
  const int row = attachment / 3;
  const double top = 0.5 * height * row;
  const Transform frame =
      plane->to_plan * moved_by(entity.place(10)) * turned_by(angle_of(entity, plane->to_plan));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    LetterLine line = like;
    line.words = lines[i];
    std::ranges::replace(line.words, kHeldBlank, ' ');
    const double base_line = top - like.size - step * static_cast<double>(i);
    line.to_mm = frame * moved_by({0.0, base_line});
    if (!line.words.empty()) letters.lines.push_back(std::move(line));
  }
  return letters;
}

}  // namespace

bool is_dxf_text(std::string_view type) {
  static constexpr std::array<std::string_view, 4> kTypes{"TEXT", "MTEXT", "ATTRIB", "ATTDEF"};
  return std::ranges::find(kTypes, type) != kTypes.end();
}

DxfLetters dxf_letters(const DxfEntity& entity, const DxfStyle& style, text::Lettering& lettering) {
  return entity.type == "MTEXT" ? paragraphs(entity, style, lettering)
                                : text_line(entity, style, lettering);
}

}  // namespace sim::drawing
