#include "host-sim/plot/cut_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>
#include <vector>

#include "host-sim/cut/cut_report.hpp"
#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "host-sim/knowledge/experiment.hpp"
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

constexpr double kPictureWidthPx = 1600.0;
constexpr double kCutMarginPx = 90.0;
constexpr double kCutTallestPx = 1600.0;
constexpr double kTextLinePx = 28.0;
constexpr std::size_t kMostLayerLines = 6;

// Told apart by people who are blind to red and green, and in grey, by lightness and by their
// widths: of the palette of M. Okabe and K. Ito, "Color universal design", 2008.
constexpr std::string_view kPartColour = "#d8dde3";
constexpr std::string_view kBandColour = "#e69f00";
constexpr std::string_view kPathColour = "#000000";
constexpr std::string_view kLeadColour = "#0072b2";
constexpr std::string_view kTabRim = "#000000";
constexpr std::string_view kTabColour = "#f0e442";
constexpr double kTabRimPx = 8.0;
constexpr double kTabPx = 4.5;
constexpr std::string_view kRapidColour = "#7a7f87";

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
  const double width_px = kPictureWidthPx - 2.0 * kCutMarginPx;
  const double natural_px = width_px * framed.height_mm() / framed.width_mm();
  return View{framed,
              {kCutMarginPx, heading_px, width_px, std::clamp(natural_px, 200.0, kCutTallestPx)}};
}

void add_stroke(std::string& data, const Stroke& stroke, bool joins, const View& view) {
  const double x_px = view.x_px(stroke.from.x());
  const double y_px = view.y_px(stroke.from.y());
  if (!joins) fmt::format_to(std::back_inserter(data), "M{:.2f} {:.2f}", x_px, y_px);
  svg::add_bulge(
      data, x_px, y_px, view.x_px(stroke.to.x()), view.y_px(stroke.to.y()), stroke.bulge);
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

/// But the one from zero to the first cut, and the one after the last.
void add_rapids(std::string& out, const cut::CutPlan& plan, const View& view) {
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    const std::vector<Place> way = cut::rapid_before(plan, i);
    for (std::size_t k = 1; i != 0 && k < way.size(); ++k) {
      svg::add_line(out,
                    view.x_px(way[k - 1].x()),
                    view.y_px(way[k - 1].y()),
                    view.x_px(way[k].x()),
                    view.y_px(way[k].y()),
                    {kRapidColour, 1.2, "7 6"});
    }
    fmt::format_to(std::back_inserter(out),
                   "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"4\" fill=\"{}\"/>\n",
                   view.x_px(way.back().x()),
                   view.y_px(way.back().y()),
                   kLeadColour);
  }
}

/// In the order of cutting, beside the start of each.
void add_numbers(std::string& out, const cut::CutPlan& plan, const View& view) {
  constexpr double kNumberPx = 17.0;
  for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
    const Place& start = plan.cuts[i].start();
    svg::add_rimmed_text(out,
                         view.x_px(start.x()) + 7.0,
                         view.y_px(start.y()) - 7.0,
                         kNumberPx,
                         fmt::format("{}", i + 1));
  }
}

void add_key(std::string& out, double y_px) {
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
                                       {"tab", kTabColour, kTabPx, ""},
                                       {"rapid", kRapidColour, 1.2, "7 6"}}};
  double x_px = kCutMarginPx;
  constexpr double kStepPx = 235.0;
  for (const Sample& sample : samples) {
    if (sample.colour == kTabColour) {
      svg::add_line(out, x_px, y_px, x_px + 40.0, y_px, {kTabRim, kTabRimPx});
    }
    svg::add_line(
        out, x_px, y_px, x_px + 40.0, y_px, {sample.colour, sample.width_px, sample.dashes});
    svg::add_text(out, x_px + 50.0, y_px + 7.0, {.size_px = 20.0}, sample.name);
    x_px += kStepPx;
  }
}

/// Size, lengths and, of each layer that is cut, power, feed and kerf.
std::vector<std::string> facts_of(const drawing::Drawing& drawn, const cut::CutPlan& plan) {
  Extent parts;
  for (const drawing::DrawnContour& contour : drawn.contours) {
    for (const Place& place : outline_of(contour.shapes, drawing::kChordToleranceMm)) {
      parts.include(place.x(), place.y());
    }
  }
  const cut::CutFigures figures = cut::figures_of(plan);
  std::vector<std::string> facts;
  facts.push_back(fmt::format(
      "{:.1f} \u00d7 {:.1f} mm  \u00b7  {} cuts  \u00b7  {:.1f} mm cut, {:.1f} mm rapid",
      parts.is_empty() ? 0.0 : parts.width_mm(),
      parts.is_empty() ? 0.0 : parts.height_mm(),
      figures.cuts,
      figures.cut_length_mm,
      figures.rapid_length_mm));
  std::set<std::size_t> layers;
  for (const Cut& cut : plan.cuts) layers.insert(cut.layer);
  for (const std::size_t layer : layers) {
    if (facts.size() > kMostLayerLines) {
      facts.push_back(fmt::format("and {} more layers", layers.size() - kMostLayerLines));
      break;
    }
    const cut::Condition& condition = plan.layers[layer].condition;
    facts.push_back(fmt::format("layer \"{}\" {}: {:g} W at {:g} mm/min, kerf {:.4f} mm",
                                drawn.layers[layer].name,
                                drawn.layers[layer].colour,
                                from_thousandths(condition.cut.power_mw),
                                from_thousandths(condition.cut.speed_um_min),
                                condition.kerf_mm));
  }
  return facts;
}

}  // namespace

std::string draw_cuts(const drawing::Drawing& drawn,
                      const cut::CutPlan& plan,
                      const std::string& title,
                      const cut::EdgeFigures* edges) {
  const std::vector<std::string> facts = facts_of(drawn, plan);
  constexpr double kFirstFactPx = 94.0;
  const double key_px = kFirstFactPx + kTextLinePx * static_cast<double>(facts.size()) + 4.0;
  const double edge_key_px = key_px + 34.0;
  const double heading_px = (edges != nullptr ? edge_key_px : key_px) + 40.0;
  const View view = view_of_cuts(bounds_of(drawn, plan), heading_px);
  const double height_px = view.box().bottom_px() + kCutMarginPx;
  std::string out = svg::document_start(kPictureWidthPx, height_px);
  svg::add_box(out, {0.0, 0.0, kPictureWidthPx, height_px}, "#ffffff");
  svg::add_text(out, kCutMarginPx, 60.0, {.size_px = 30.0, .weight = "bold"}, title);
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const double y_px = kFirstFactPx + kTextLinePx * static_cast<double>(i);
    svg::add_text(out, kCutMarginPx, y_px, {.size_px = 20.0, .fill = "#444a52"}, facts[i]);
  }
  add_key(out, key_px);
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
    add_path(out, data_of(cut, view, tab), kTabRim, kTabRimPx);
    add_path(out, data_of(cut, view, tab), kTabColour, kTabPx);
  }
  add_rapids(out, plan, view);
  if (edges != nullptr) add_edges(out, *edges, view, edge_key_px);
  add_numbers(out, plan, view);
  return out + "</svg>\n";
}

}  // namespace sim
