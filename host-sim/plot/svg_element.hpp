#pragma once

#include <string>
#include <string_view>

#include "host-sim/plot/view.hpp"

namespace sim::svg {

struct TextStyle {
  double size_px;
  std::string_view anchor = "start";  ///< `start`, `middle` or `end`.
  std::string_view fill = "#222222";
  std::string_view weight = "normal";
};

struct LineStyle {
  std::string_view stroke;
  double width_px;
  std::string_view dashes_px{};  ///< Value of stroke-dasharray; empty for a solid line.
};

/// Returns the text in a form that XML can hold: markup is escaped, control characters become
/// spaces, and bytes that are not UTF-8 become `?`.
[[nodiscard]] std::string escaped(std::string_view text);

/// Appends a line or an arc to path data that ends at (x1, y1). The bulge is tan(sweep / 4),
/// positive to the left in a drawing whose y runs upwards. A flat arc becomes a curve with its
/// tangents, because renderers lose accuracy with the distant centre of its circle.
void add_bulge(
    std::string& data, double x1_px, double y1_px, double x2_px, double y2_px, double bulge);

/// Appends a number or a short text with a white rim, so that it can be read over lines.
void add_rimmed_text(
    std::string& out, double x_px, double y_px, double size_px, std::string_view text);

/// Returns the start of a picture, with the font of its text; `</svg>` ends the picture. The
/// picture has the given width, and is smaller if a browser's window is.
[[nodiscard]] std::string document_start(double width_px, double height_px);

/// Append one element to `out`, with coordinates in px.
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
