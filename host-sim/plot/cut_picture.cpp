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
#include "host-sim/import/curve_measure.hpp"
#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/plot/cut_marks.hpp"
#include "host-sim/plot/grid.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {
namespace {

using cut::Cut;
using drawing::Place;

constexpr double kCutPictureWidthPx = 1600.0;
constexpr double kCutMarginPx = 90.0;
constexpr double kCutTallestPx = 1600.0;
constexpr double kTextLinePx = 28.0;
constexpr double kSamplePx = 34.0;
constexpr std::size_t kMaxLayerLines = 6;

View view_of_cuts(const Extent& extent, double heading_px) {
  const Extent framed = framed_cuts(extent);
  const double width_px = kCutPictureWidthPx - 2.0 * kCutMarginPx;
  const double natural_px = width_px * framed.height_mm() / framed.width_mm();
  return View{framed,
              {kCutMarginPx, heading_px, width_px, std::clamp(natural_px, 200.0, kCutTallestPx)}};
}

/// Appends to the key a sample of the dot that marks the start of a lead, at which the beam pierces
/// the sheet.
void add_pierce_sample(std::string& out, double x_px, double y_px) {
  fmt::format_to(std::back_inserter(out),
                 "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"{}\"/>\n",
                 x_px,
                 y_px,
                 kLeadColour);
}

void add_key(std::string& out, double y_px) {
  struct Sample {
    std::string_view name;
    std::string_view colour;
    double width_px;
    std::string_view dashes;
  };
  const std::array<Sample, 7> samples{{{"part", kPartColour, 14.0, ""},
                                       {"kerf", kBandColour, 14.0, ""},
                                       {"beam's path", kBeamColour, 2.0, ""},
                                       {"leads, loops", kLeadColour, 3.0, ""},
                                       {"tab", kTabColour, kTabPx, ""},
                                       {"rapid", kRapidColour, kRapidPx, kRapidDashes},
                                       {"warm pierce", "#f0bf99", 14.0, ""}}};
  double x_px = kCutMarginPx;
  for (const Sample& sample : samples) {
    if (sample.colour == kTabColour) {
      svg::add_line(out, x_px, y_px, x_px + kSamplePx, y_px, {kTabRim, kTabRimPx});
    }
    svg::add_line(
        out, x_px, y_px, x_px + kSamplePx, y_px, {sample.colour, sample.width_px, sample.dashes});
    if (sample.colour == kLeadColour) add_pierce_sample(out, x_px, y_px);
    svg::add_text(out, x_px + kSamplePx + 9.0, y_px + 7.0, {.size_px = 20.0}, sample.name);
    x_px += kSamplePx + 44.0 + 11.4 * static_cast<double>(sample.name.size());
  }
}

/// Returns the lines of text below the title: first size and lengths, then power, feed and kerf of
/// each layer that is cut.
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
    if (facts.size() > kMaxLayerLines) {
      facts.push_back(fmt::format("and {} more layers", layers.size() - kMaxLayerLines));
      break;
    }
    const cut::Condition& condition = plan.layers[layer].condition;
    facts.push_back(fmt::format("layer \"{}\" {}: {:g} W at {:g} mm/min, {}",
                                drawn.layers[layer].name,
                                drawn.layers[layer].colour,
                                from_thousandths(condition.cut.power_mw),
                                from_thousandths(condition.cut.speed_um_min),
                                width_text(plan.layers[layer])));
  }
  return facts;
}

}  // namespace

std::string draw_cuts(const CutScene& scene,
                      const std::string& title,
                      const cut::EdgeFigures* edges) {
  const std::vector<std::string> facts = facts_of(scene.drawn, scene.plan);
  constexpr double kFirstFactPx = 94.0;
  const double key_px = kFirstFactPx + kTextLinePx * static_cast<double>(facts.size()) + 4.0;
  const double edge_key_px = key_px + 34.0;
  const double heading_px = (edges != nullptr ? edge_key_px : key_px) + 40.0;
  const View view = view_of_cuts(extent_of(scene), heading_px);
  const double height_px = std::ceil(view.box().bottom_px() + kCutMarginPx);
  std::string out = svg::document_start(kCutPictureWidthPx, height_px);
  svg::add_box(out, {0.0, 0.0, kCutPictureWidthPx, height_px}, "#ffffff");
  svg::add_text(out, kCutMarginPx, 60.0, {.size_px = 30.0, .weight = "bold"}, title);
  for (std::size_t i = 0; i < facts.size(); ++i) {
    const double y_px = kFirstFactPx + kTextLinePx * static_cast<double>(i);
    svg::add_text(out, kCutMarginPx, y_px, {.size_px = 20.0, .fill = "#444a52"}, facts[i]);
  }
  add_key(out, key_px);
  add_grid(out, view);
  add_cut_layers(out, scene, view, edges, edge_key_px);
  return out + "</svg>\n";
}

}  // namespace sim
