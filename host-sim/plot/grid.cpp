#include "host-sim/plot/grid.hpp"

#include <fmt/format.h>

#include "host-sim/plot/svg_element.hpp"

namespace sim {
namespace {

constexpr double kMinSpacingPx = 90.0;
constexpr svg::LineStyle kGridLine{"#e9ebee", 1.0};
constexpr svg::LineStyle kAxisLine{"#c3c8cf", 1.5};
constexpr std::string_view kLabelFill = "#5b626c";

/// Returns the label of the grid line with number `index`, with as many decimals as the spacing
/// requires.
std::string label_of(long long index, double spacing_mm) {
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(spacing_mm) + 1e-9)));
  return fmt::format("{:.{}f}", static_cast<double>(index) * spacing_mm, decimals);
}

/// Returns the style of a grid line. The lines through the origin of the machine are emphasized.
const svg::LineStyle& style_of(long long index) { return index == 0 ? kAxisLine : kGridLine; }

void add_columns(std::string& out, const View& view, double spacing_mm) {
  const Box& box = view.box();
  const auto last = static_cast<long long>(std::floor(view.x_mm(box.right_px()) / spacing_mm));
  auto i = static_cast<long long>(std::ceil(view.x_mm(box.left_px) / spacing_mm));
  for (; i <= last; ++i) {
    const double x_px = view.x_px(static_cast<double>(i) * spacing_mm);
    svg::add_line(out, x_px, box.top_px, x_px, box.bottom_px(), style_of(i));
    svg::add_text(out,
                  x_px,
                  box.bottom_px() + 28.0,
                  {.size_px = 20.0, .anchor = "middle", .fill = kLabelFill},
                  label_of(i, spacing_mm));
  }
}

void add_rows(std::string& out, const View& view, double spacing_mm) {
  const Box& box = view.box();
  const auto last = static_cast<long long>(std::floor(view.y_mm(box.top_px) / spacing_mm));
  auto i = static_cast<long long>(std::ceil(view.y_mm(box.bottom_px()) / spacing_mm));
  for (; i <= last; ++i) {
    const double y_px = view.y_px(static_cast<double>(i) * spacing_mm);
    svg::add_line(out, box.left_px, y_px, box.right_px(), y_px, style_of(i));
    svg::add_text(out,
                  box.left_px - 12.0,
                  y_px + 7.0,
                  {.size_px = 20.0, .anchor = "end", .fill = kLabelFill},
                  label_of(i, spacing_mm));
  }
}

}  // namespace

void add_grid(std::string& out, const View& view, std::string_view axes) {
  const double spacing_mm = round_step(kMinSpacingPx / view.px_per_mm());
  add_columns(out, view, spacing_mm);
  add_rows(out, view, spacing_mm);
  const Box& box = view.box();
  svg::add_text(out,
                box.right_px(),
                box.bottom_px() + 56.0,
                {.size_px = 20.0, .anchor = "end", .fill = kLabelFill},
                axes);
}

}  // namespace sim
