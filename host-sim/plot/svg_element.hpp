#pragma once

#include <string>
#include <string_view>

#include "host-sim/plot/view.hpp"

namespace sim::svg {

struct TextStyle {
  double size_px;
  /// Part of the text that is placed at the given position: `start`, `middle` or `end`.
  std::string_view anchor = "start";
  std::string_view fill = "#222222";
  std::string_view weight = "normal";
};

struct LineStyle {
  std::string_view stroke;
  double width_px;
  /// Value of the attribute stroke-dasharray; empty for a solid line.
  std::string_view dashes_px{};
};

/// Returns a text in a form that XML can contain: markup is escaped, control characters are
/// replaced by spaces, and bytes that are not UTF-8 by `?`.
[[nodiscard]] std::string escaped(std::string_view text);

/// Appends a line or an arc to path data that ends at (x1, y1). The bulge is tan(sweep / 4), and is
/// positive if the arc turns left in a drawing whose y points upwards. A flat arc is drawn as a
/// cubic curve with the same tangents: renderers lose accuracy if the centre of an arc is far away.
void add_bulge(
    std::string& data, double x1_px, double y1_px, double x2_px, double y2_px, double bulge);

/// Appends a number or a short text with a white rim, so that it is readable on top of lines.
void add_rimmed_text(
    std::string& out, double x_px, double y_px, double size_px, std::string_view text);

/// Returns the start of an SVG document, which sets the font of its texts. The caller ends the
/// document with `</svg>`. The picture has the given width, but shrinks to the window of a browser
/// if the window is smaller.
[[nodiscard]] std::string document_start(double width_px, double height_px);

/// Append one SVG element to `out`. Coordinates are in px.
void add_text(
    std::string& out, double x_px, double y_px, const TextStyle& style, std::string_view text);
void add_line(std::string& out,
              double x1_px,
              double y1_px,
              double x2_px,
              double y2_px,
              const LineStyle& style);
void add_box(std::string& out, const Box& box, std::string_view fill);

}  // namespace sim::svg
