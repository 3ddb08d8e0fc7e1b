#pragma once

#include <string>
#include <string_view>

#include "host-sim/plot/view.hpp"

namespace sim::svg {

struct TextStyle {
  double size_px;
  std::string_view anchor = "start";  ///< start, middle or end.
  std::string_view fill = "#222222";
  std::string_view weight = "normal";
};

struct LineStyle {
  std::string_view stroke;
  double width_px;
  std::string_view dashes_px{};  ///< As in stroke-dasharray; empty for a full line.
};

/// Text that XML can hold: markup escaped, control characters as spaces, bytes
/// that are no UTF-8 as `?`.
[[nodiscard]] std::string escaped(std::string_view text);

/// Appends a line or an arc to path data that is at (x1, y1); bulge = tan(sweep / 4), positive to
/// the left in a drawing whose y runs upwards. Flat arcs are curves of their tangents instead of
/// parts of a circle, whose far centre renderers lose.
void add_bulge(
    std::string& data, double x1_px, double y1_px, double x2_px, double y2_px, double bulge);

/// A number or a short text with a white rim, to be read over lines.
void add_rimmed_text(
    std::string& out, double x_px, double y_px, double size_px, std::string_view text);

/// The start of a picture, with the font of its text; `</svg>` ends it. It is as wide as given, and
/// smaller where a browser's window is.
[[nodiscard]] std::string document_start(double width_px, double height_px);

/// Append one element to `out`, coordinates in px.
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
