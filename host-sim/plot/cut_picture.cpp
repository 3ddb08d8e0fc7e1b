#include "host-sim/plot/cut_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/plot/drawing_picture.hpp"
#include "host-sim/plot/edge_layer.hpp"
#include "host-sim/plot/grid.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {
namespace {

using cut::Cut;
using cut::Purpose;
using cut::Stroke;
using drawing::Place;

constexpr double kCutWidthPx = 1600.0;
constexpr double kCutMarginPx = 90.0;
constexpr double kCutHeadingPx = 150.0;
constexpr double kEdgeHeadingPx = 180.0;
constexpr double kEdgeKeyPx = 142.0;
constexpr double kCutTallestPx = 1600.0;

constexpr std::string_view kPartColour = "#d8dde3";
constexpr std::string_view kBandColour = "#e8833a";
constexpr std::string_view kPathColour = "#b01818";
constexpr std::string_view kLeadColour = "#1f5fbf";
constexpr std::string_view kTabColour = "#178a3c";
constexpr std::string_view kRapidColour = "#8a8f98";

bool is_lead(const Stroke& stroke) {
  return stroke.purpose != Purpose::kContour && stroke.purpose != Purpose::kTab;
}

Extent bounds_of(const drawing::Drawing& drawn, const cut::CutPlan& plan) {
  Extent bounds;
  for (const drawing::DrawnContour& contour : drawn.contours) {
    for (const Place& place : outline_of(contour.shapes, drawing::kChordToleranceMm)) {
      bounds.include(place.x(), place.y());
    }
  }
  constexpr int kLooks = 8;
  for (const Cut& cut : plan.cuts) {
    for (const Stroke& stroke : cut.strokes) {
      for (int i = 0; i <= kLooks; ++i) {
        const Place place = place_at(stroke, static_cast<double>(i) / kLooks);
        bounds.include(place.x(), place.y());
      }
    }
  }
  if (bounds.is_empty()) bounds.include(0.0, 0.0);
  return bounds;
}

View view_of_cuts(const Extent& extent, double heading_px) {
  const double size_mm = std::max({extent.width_mm(), extent.height_mm(), 1.0e-3});
  const double margin = 0.04 * size_mm;
  const Extent framed{extent.left_mm - margin,
                      extent.right_mm + margin,
                      extent.bottom_mm - margin,
                      extent.top_mm + margin};
  const double width_px = kCutWidthPx - 2.0 * kCutMarginPx;
  const double natural_px = width_px * framed.height_mm() / framed.width_mm();
  return View{framed,
              {kCutMarginPx, heading_px, width_px, std::clamp(natural_px, 200.0, kCutTallestPx)}};
}

/// Arcs of the document turn the other way, as its y runs downwards.
void add_stroke(std::string& data, const Stroke& stroke, bool joins, const View& view) {
  if (!joins) {
    fmt::format_to(std::back_inserter(data),
                   "M{:.2f} {:.2f}",
                   view.x_px(stroke.from.x()),
                   view.y_px(stroke.from.y()));
  }
  const double x_px = view.x_px(stroke.to.x());
  const double y_px = view.y_px(stroke.to.y());
  const double size = std::abs(stroke.bulge);
  if (size == 0.0) {
    fmt::format_to(std::back_inserter(data), "L{:.2f} {:.2f}", x_px, y_px);
    return;
  }
  const double chord_px = drawing::distance(stroke.from, stroke.to) * view.px_per_mm();
  fmt::format_to(std::back_inserter(data),
                 "A{0:.6g} {0:.6g} 0 {1} {2} {3:.2f} {4:.2f}",
                 chord_px * (1.0 + size * size) / (4.0 * size),
                 size > 1.0 ? 1 : 0,
                 stroke.bulge > 0.0 ? 0 : 1,
                 x_px,
                 y_px);
}

/// All strokes of a cut that are asked for, as path data.
template <typename Wanted>
std::string data_of(const Cut& cut, const View& view, Wanted wanted) {
  std::string data;
  bool joins = false;
  for (const Stroke& stroke : cut.strokes) {
    if (wanted(stroke)) add_stroke(data, stroke, joins, view);
    joins = wanted(stroke);
  }
  return data;
}

void add_path(std::string& out, const std::string& data, std::string_view colour, double width_px) {
  if (data.empty()) return;
  fmt::format_to(std::back_inserter(out),
                 "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\" "
                 "stroke-linecap=\"round\" stroke-linejoin=\"round\"/>\n",
                 data,
                 colour,
                 width_px);
}

void add_parts(std::string& out, const drawing::Drawing& drawn, const View& view) {
  std::string data;
  for (const drawing::DrawnContour& contour : drawn.contours) add_outline(data, contour, view);
  fmt::format_to(std::back_inserter(out),
                 "<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"#222222\" "
                 "stroke-width=\"1.2\"/>\n",
                 data,
                 kPartColour);
}

void add_rapids(std::string& out, const cut::CutPlan& plan, const View& view) {
  Place here{0.0, 0.0};
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    const Place& start = plan.cuts[i].start();
    if (i != 0) {
      svg::add_line(out,
                    view.x_px(here.x()),
                    view.y_px(here.y()),
                    view.x_px(start.x()),
                    view.y_px(start.y()),
                    {kRapidColour, 1.2, "7 6"});
    }
    here = plan.cuts[i].end();
    fmt::format_to(std::back_inserter(out),
                   "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" fill=\"{}\"/>\n",
                   view.x_px(start.x()),
                   view.y_px(start.y()),
                   kLeadColour);
  }
}

void add_key(std::string& out) {
  struct Sample {
    std::string_view name;
    std::string_view colour;
    double width_px;
    std::string_view dashes;
  };
  const std::array<Sample, 6> samples{{{"part", kPartColour, 14.0, ""},
                                       {"kerf", kBandColour, 14.0, ""},
                                       {"beam's path", kPathColour, 2.0, ""},
                                       {"leads, loops", kLeadColour, 3.0, ""},
                                       {"tab", kTabColour, 3.0, ""},
                                       {"rapid", kRapidColour, 1.2, "7 6"}}};
  double x_px = kCutMarginPx;
  constexpr double kStepPx = 235.0;
  for (const Sample& sample : samples) {
    svg::add_line(
        out, x_px, 108.0, x_px + 40.0, 108.0, {sample.colour, sample.width_px, sample.dashes});
    svg::add_text(out, x_px + 50.0, 115.0, {.size_px = 20.0}, sample.name);
    x_px += kStepPx;
  }
}

}  // namespace

std::string draw_cuts(const drawing::Drawing& drawn,
                      const cut::CutPlan& plan,
                      const std::string& title,
                      const cut::EdgeFigures* edges) {
  const double heading_px = edges != nullptr ? kEdgeHeadingPx : kCutHeadingPx;
  const View view = view_of_cuts(bounds_of(drawn, plan), heading_px);
  const double height_px = view.box().bottom_px() + kCutMarginPx;
  std::string out = svg::document_start(kCutWidthPx, height_px);
  svg::add_box(out, {0.0, 0.0, kCutWidthPx, height_px}, "#ffffff");
  svg::add_text(out, kCutMarginPx, 60.0, {.size_px = 30.0, .weight = "bold"}, title);
  add_key(out);
  add_grid(out, view);
  add_parts(out, drawn, view);
  for (const Cut& cut : plan.cuts) {
    const double kerf_px = plan.layers[cut.layer].condition.kerf_mm * view.px_per_mm();
    const auto lit = [](const Stroke& stroke) { return stroke.purpose != Purpose::kTab; };
    out += "<g opacity=\"0.6\">\n";
    add_path(out, data_of(cut, view, lit), kBandColour, kerf_px);
    out += "</g>\n";
  }
  for (const Cut& cut : plan.cuts) {
    const auto along = [](const Stroke& stroke) { return stroke.purpose == Purpose::kContour; };
    const auto tab = [](const Stroke& stroke) { return stroke.purpose == Purpose::kTab; };
    add_path(out, data_of(cut, view, along), kPathColour, 1.4);
    add_path(out, data_of(cut, view, is_lead), kLeadColour, 2.0);
    add_path(out, data_of(cut, view, tab), kTabColour, 3.0);
  }
  add_rapids(out, plan, view);
  if (edges != nullptr) add_edges(out, *edges, view, kEdgeKeyPx);
  return out + "</svg>\n";
}

}  // namespace sim
