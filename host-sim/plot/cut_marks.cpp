#include "host-sim/plot/cut_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "host-sim/cut/heat.hpp"
#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/plot/cut_numbers.hpp"
#include "host-sim/plot/svg_element.hpp"

namespace sim {
namespace {

/// Least length of a rapid that has an arrow head.
constexpr double kMinArrowPx = 24.0;
constexpr double kArrowPx = 9.0;
/// Heat below kMinHeat is not shown. Above kFullHeat the colour does not become stronger.
constexpr double kMinHeat = 0.15;
constexpr double kFullHeat = 1.5;
constexpr double kFullHeatOpacity = 0.8;

PicturePlace on_picture(const drawing::Place& place, const View& view) {
  return {view.x_px(place.x()), view.y_px(place.y())};
}

NumberLayout layout_for(std::size_t cuts) {
  return {.size_px = number_size_px(cuts), .dot_px = pierce_radius_px(cuts)};
}

}  // namespace

double pierce_radius_px(std::size_t cuts) { return cuts <= 400 ? 4.0 : 2.5; }

void add_arrow_head(std::string& data, double x1_px, double y1_px, double x2_px, double y2_px) {
  const double length = std::hypot(x2_px - x1_px, y2_px - y1_px);
  if (length < kMinArrowPx) return;
  const double along_x = kArrowPx * (x2_px - x1_px) / length;
  const double along_y = kArrowPx * (y2_px - y1_px) / length;
  const double tip_x = 0.5 * (x1_px + x2_px) + 0.5 * along_x;
  const double tip_y = 0.5 * (y1_px + y2_px) + 0.5 * along_y;
  constexpr double kHalfWidth = 0.4;
  fmt::format_to(std::back_inserter(data),
                 "M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}Z",
                 tip_x,
                 tip_y,
                 tip_x - along_x - kHalfWidth * along_y,
                 tip_y - along_y + kHalfWidth * along_x,
                 tip_x - along_x + kHalfWidth * along_y,
                 tip_y - along_y - kHalfWidth * along_x);
}

void add_rapids(std::string& out, const cut::CutPlan& plan, const View& view) {
  std::string lines;
  std::string heads;
  for (std::size_t i = 1; i < plan.cuts.size(); ++i) {
    const std::vector<cut::Place> way = cut::rapid_before(plan, i);
    PicturePlace from = on_picture(way.front(), view);
    fmt::format_to(std::back_inserter(lines), "M{:.1f} {:.1f}", from.x_px, from.y_px);
    for (std::size_t k = 1; k < way.size(); ++k) {
      const PicturePlace to = on_picture(way[k], view);
      fmt::format_to(std::back_inserter(lines), "L{:.1f} {:.1f}", to.x_px, to.y_px);
      if (k + 1 == way.size()) add_arrow_head(heads, from.x_px, from.y_px, to.x_px, to.y_px);
      from = to;
    }
  }
  if (lines.empty()) return;
  fmt::format_to(std::back_inserter(out),
                 "<g class=\"rapids\" fill=\"{0}\"><path stroke=\"{0}\" stroke-width=\"{1}\" "
                 "stroke-dasharray=\"{2}\" fill=\"none\" d=\"{3}\"/>",
                 kRapidColour,
                 kRapidPx,
                 kRapidDashes,
                 lines);
  if (!heads.empty()) fmt::format_to(std::back_inserter(out), "<path d=\"{}\"/>", heads);
  out += "</g>\n";
}

void add_pierces(std::string& out, const cut::CutPlan& plan, const View& view) {
  const double radius = pierce_radius_px(plan.cuts.size());
  out += "<g class=\"pierces\" fill=\"#0072b2\">\n";
  for (const cut::Cut& cut : plan.cuts) {
    if (cut.strokes.front().purpose == cut::Purpose::kLink) continue;
    const PicturePlace place = on_picture(cut.start(), view);
    fmt::format_to(std::back_inserter(out),
                   "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\"/>\n",
                   place.x_px,
                   place.y_px,
                   radius);
  }
  out += "</g>\n";
}

void add_numbers(std::string& out, const cut::CutPlan& plan, const View& view) {
  std::vector<PicturePlace> pierces;
  for (const cut::Cut& cut : plan.cuts) pierces.push_back(on_picture(cut.start(), view));
  const NumberLayout layout = layout_for(pierces.size());
  for (const PlacedNumber& placed : placed_numbers(pierces, layout)) {
    svg::add_rimmed_text(out,
                         placed.place.x_px,
                         placed.place.y_px,
                         layout.size_px,
                         fmt::format("{}", placed.number));
  }
}

void add_heat(std::string& out,
              const cut::CutPlan& plan,
              const std::vector<double>& heat,
              const View& view) {
  if (std::ranges::none_of(heat, [](double warm) { return warm > kMinHeat; })) return;
  fmt::format_to(std::back_inserter(out),
                 "<defs><radialGradient id=\"heat\"><stop offset=\"0\" stop-color=\"{0}\"/><stop "
                 "offset=\"1\" stop-color=\"{0}\" stop-opacity=\"0\"/></radialGradient></defs>\n<g "
                 "class=\"heat\" fill=\"url(#heat)\">\n",
                 kHeatColour);
  const double radius_px = std::clamp(cut::kHeatFadesInMm * view.px_per_mm(), 6.0, 90.0);
  for (std::size_t i = 0; i < heat.size(); ++i) {
    if (!(heat[i] > kMinHeat)) continue;
    const PicturePlace place = on_picture(plan.cuts[i].start(), view);
    fmt::format_to(std::back_inserter(out),
                   "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" opacity=\"{:.2f}\"/>\n",
                   place.x_px,
                   place.y_px,
                   radius_px,
                   kFullHeatOpacity * std::min(heat[i] / kFullHeat, 1.0));
  }
  out += "</g>\n";
}

}  // namespace sim
