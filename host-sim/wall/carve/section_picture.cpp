#include "host-sim/wall/carve/section_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "host-sim/plot/grid.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/plot/view.hpp"

namespace sim::wall {
namespace {

constexpr double kWidthPx = 1600.0;
constexpr double kSidePx = 110.0;
constexpr double kHeadPx = 80.0;
constexpr double kCaptionPx = 50.0;
constexpr double kFootPx = 80.0;
constexpr double kTallestPx = 900.0;
constexpr double kFlattestPx = 120.0;

/// Returns the extent of a picture of the section through a block, with a margin.
Extent extent_of(const stock::StockBox& box, const SectionLine& line) {
  const double margin = 0.05 * std::max(box.top - box.bottom, 0.1 * line.length_mm());
  return {-margin, line.length_mm() + margin, box.bottom - margin, box.top + margin};
}

void add_bars(std::string& out, const View& view, const std::vector<SectionBar>& bars) {
  out += R"(<path fill="#aab2bd" shape-rendering="crispEdges" d=")";
  for (const SectionBar& bar : bars) {
    fmt::format_to(std::back_inserter(out),
                   "M{:.2f} {:.2f}H{:.2f}V{:.2f}H{:.2f}Z",
                   view.x_px(bar.from_mm),
                   view.y_px(bar.range.high),
                   view.x_px(bar.until_mm),
                   view.y_px(bar.range.low),
                   view.x_px(bar.from_mm));
  }
  out += "\"/>\n";
}

void add_part(std::string& out,
              const View& view,
              const std::vector<std::array<Eigen::Vector2d, 2>>& lines) {
  out += R"(<path fill="none" stroke="#d62728" stroke-width="2" d=")";
  for (const auto& [a, b] : lines) {
    fmt::format_to(std::back_inserter(out),
                   "M{:.2f} {:.2f}L{:.2f} {:.2f}",
                   view.x_px(a.x()),
                   view.y_px(a.y()),
                   view.x_px(b.x()),
                   view.y_px(b.y()));
  }
  out += "\"/>\n";
}

}  // namespace

std::string draw_sections(const std::string& title,
                          const std::vector<CarvedSection>& sections,
                          const surface::Mesh& part,
                          const SectionLine& line) {
  const Extent extent = extent_of(sections.front().columns->box(), line);
  const double width_px = kWidthPx - 2.0 * kSidePx;
  const double natural_px = width_px * extent.height_mm() / extent.width_mm();
  const double height_px = std::clamp(natural_px, kFlattestPx, kTallestPx);
  const double panel_px = kCaptionPx + height_px + kFootPx;
  std::string out =
      svg::document_start(kWidthPx, kHeadPx + static_cast<double>(sections.size()) * panel_px);
  svg::add_box(out,
               {0.0, 0.0, kWidthPx, kHeadPx + static_cast<double>(sections.size()) * panel_px},
               "#ffffff");
  svg::add_text(out, kSidePx, 52.0, {.size_px = 34.0, .weight = "bold"}, title);
  const auto part_lines = section_of(part, line);
  double top_px = kHeadPx;
  for (const CarvedSection& section : sections) {
    const View view{extent, {kSidePx, top_px + kCaptionPx, width_px, height_px}};
    svg::add_text(out, kSidePx, top_px + 30.0, {.size_px = 24.0}, section.caption);
    add_grid(out, view, "along the section and Z, mm");
    add_bars(out, view, section_of(*section.columns, line));
    add_part(out, view, part_lines);
    top_px += panel_px;
  }
  return out + "</svg>\n";
}

}  // namespace sim::wall
