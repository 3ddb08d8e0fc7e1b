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

/// The start of a picture, with the font of its text; `</svg>` ends it.
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
