#include "host-sim/plot/svg_element.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "host-sim/report/utf8.hpp"

namespace sim::svg {
namespace {

std::string_view entity_of(std::string_view character, char32_t code_point) {
  if (code_point < 0x20) return " ";
  if (code_point == 0xFFFE || code_point == 0xFFFF) return "?";
  switch (character.front()) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return character;
  }
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    const std::string_view bytes = text.substr(0, character.bytes);
    result += character.is_valid ? entity_of(bytes, character.code_point) : "?";
    text.remove_prefix(character.bytes);
  }
  return result;
}

void add_text(
    std::string& out, double x_px, double y_px, const TextStyle& style, std::string_view text) {
  fmt::format_to(std::back_inserter(out),
                 R"(<text x="{:.1f}" y="{:.1f}" font-size="{}" text-anchor="{}" fill="{}" )"
                 R"(font-weight="{}">{}</text>)"
                 "\n",
                 x_px,
                 y_px,
                 style.size_px,
                 style.anchor,
                 style.fill,
                 style.weight,
                 escaped(text));
}

void add_line(std::string& out,
              double x1_px,
              double y1_px,
              double x2_px,
              double y2_px,
              const LineStyle& style) {
  fmt::format_to(std::back_inserter(out),
                 R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="{}" stroke-width="{}")",
                 x1_px,
                 y1_px,
                 x2_px,
                 y2_px,
                 style.stroke,
                 style.width_px);
  if (!style.dashes_px.empty()) out += fmt::format(R"( stroke-dasharray="{}")", style.dashes_px);
  out += "/>\n";
}

void add_bulge(
    std::string& data, double x1_px, double y1_px, double x2_px, double y2_px, double bulge) {
  // Greatest bulge of an arc that is drawn as a cubic curve. The arc then turns by 23 degrees, and
  // the curve is exact to 2e-8 of the chord.
  constexpr double kFlat = 0.1;
  const double size = std::abs(bulge);
  const double chord_px = std::hypot(x2_px - x1_px, y2_px - y1_px);
  if (size == 0.0 || chord_px == 0.0) {
    fmt::format_to(std::back_inserter(data), "L{:.2f} {:.2f}", x2_px, y2_px);
  } else if (size > kFlat) {
    fmt::format_to(std::back_inserter(data),
                   "A{0:.6g} {0:.6g} 0 {1} {2} {3:.2f} {4:.2f}",
                   chord_px * (1.0 + size * size) / (4.0 * size),
                   size > 1.0 ? 1 : 0,
                   bulge > 0.0 ? 0 : 1,
                   x2_px,
                   y2_px);
  } else {
    // In the document, y points downwards, so that an arc that turns left has decreasing angles.
    const double along = std::atan2(y2_px - y1_px, x2_px - x1_px);
    const double half_turn = -2.0 * std::atan(bulge);
    const double handle_px = chord_px * (1.0 + size * size) / 3.0;
    fmt::format_to(std::back_inserter(data),
                   "C{:.3f} {:.3f} {:.3f} {:.3f} {:.2f} {:.2f}",
                   x1_px + handle_px * std::cos(along - half_turn),
                   y1_px + handle_px * std::sin(along - half_turn),
                   x2_px - handle_px * std::cos(along + half_turn),
                   y2_px - handle_px * std::sin(along + half_turn),
                   x2_px,
                   y2_px);
  }
}

void add_rimmed_text(
    std::string& out, double x_px, double y_px, double size_px, std::string_view text) {
  fmt::format_to(std::back_inserter(out),
                 R"(<text x="{:.1f}" y="{:.1f}" font-size="{}" fill="#111111" stroke="#ffffff" )"
                 R"(stroke-width="3" stroke-linejoin="round" paint-order="stroke">{}</text>)"
                 "\n",
                 x_px,
                 y_px,
                 size_px,
                 escaped(text));
}

std::string document_start(double width_px, double height_px) {
  return fmt::format(R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0:.0f}" height="{1:.0f}" )"
                     R"(viewBox="0 0 {0:.0f} {1:.0f}" style="max-width:100%;max-height:100vh" )"
                     R"(font-family="'DejaVu Sans', Verdana, sans-serif">)"
                     "\n",
                     width_px,
                     height_px);
}

void add_box(std::string& out, const Box& box, std::string_view fill) {
  fmt::format_to(std::back_inserter(out),
                 R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}"/>)"
                 "\n",
                 box.left_px,
                 box.top_px,
                 box.width_px,
                 box.height_px,
                 fill);
}

}  // namespace sim::svg
