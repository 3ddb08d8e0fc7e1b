#include "host-sim/plot/edge_layer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "host-sim/plot/svg_element.hpp"

namespace sim {
namespace {

using cut::EdgePeak;
using cut::EdgePlace;

/// A bin of deviations, with its colour. An edge belongs to the first bin whose `max_mm` is not
/// below its deviation. The deviation is positive if the part was cut into.
struct EdgeBin {
  double max_mm;
  std::string_view colour;
  std::string_view name;
};

/// The bins of deviations. Their limits are the promised accuracy and the smallest visible
/// deviation. People with red-green colour blindness can distinguish the colours from blue through
/// black to orange.
constexpr std::array<EdgeBin, 5> kEdgeBins{{{-0.02, "#08306b", "> 20 um left"},
                                            {-0.005, "#56b4e9", "> 5 um left"},
                                            {0.005, "#000000", "within 5 um"},
                                            {0.02, "#e69f00", "> 5 um off"},
                                            {1.0e9, "#d55e00", "> 20 um off"}}};
constexpr std::string_view kNotReached = "#b4b8be";

std::string_view colour_of(const EdgePlace& edge) {
  if (!edge.reached) return kNotReached;
  const auto* const bin = std::ranges::find_if(
      kEdgeBins, [&edge](const EdgeBin& each) { return edge.mm <= each.max_mm; });
  return bin->colour;
}

void add_row(std::string& out, const std::string& points, std::string_view colour) {
  fmt::format_to(std::back_inserter(out),
                 "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"4\"/>\n",
                 points,
                 colour);
}

void add_peak(std::string& out, const EdgePeak& peak, std::string_view what, const View& view) {
  if (peak.mm == 0.0) return;
  const double x_px = view.x_px(peak.place.x());
  const double y_px = view.y_px(peak.place.y());
  fmt::format_to(std::back_inserter(out),
                 "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"9\" fill=\"none\" stroke=\"#222222\" "
                 "stroke-width=\"2\"/>\n",
                 x_px,
                 y_px);
  svg::add_text(out,
                x_px + 13.0,
                y_px - 9.0,
                {.size_px = 20.0},
                fmt::format("{:.1f} um {}", 1000.0 * std::abs(peak.mm), what));
}

void add_edge_key(std::string& out, const View& view, double y_px) {
  double x_px = view.box().left_px;
  const auto sample = [&](std::string_view colour, std::string_view name) {
    svg::add_line(out, x_px, y_px, x_px + 40.0, y_px, {colour, 4.0});
    svg::add_text(out, x_px + 50.0, y_px + 7.0, {.size_px = 20.0}, name);
    x_px += 235.0;
  };
  for (const EdgeBin& bin : kEdgeBins) sample(bin.colour, bin.name);
  sample(kNotReached, "not reached");
}

}  // namespace

void add_edges(std::string& out,
               const cut::EdgeFigures& figures,
               const View& view,
               double key_y_px) {
  std::string points;
  std::string_view colour;
  for (const EdgePlace& edge : figures.profile) {
    const std::string place =
        fmt::format("{:.2f},{:.2f} ", view.x_px(edge.place.x()), view.y_px(edge.place.y()));
    const bool goes_on = edge.joins && !points.empty();
    if (goes_on) points += place;
    if (goes_on && colour_of(edge) == colour) continue;
    if (!points.empty()) add_row(out, points, colour);
    points = place;
    colour = colour_of(edge);
  }
  if (!points.empty()) add_row(out, points, colour);
  add_peak(out, figures.max_off, "off", view);
  add_peak(out, figures.max_left, "left", view);
  add_edge_key(out, view, key_y_px);
}

}  // namespace sim
