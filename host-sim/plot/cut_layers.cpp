#include "host-sim/plot/cut_layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "host-sim/cut/burnt_pictures.hpp"
#include "host-sim/cut/heat.hpp"
#include "host-sim/engrave/burn_picture.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "host-sim/plot/cut_marks.hpp"
#include "host-sim/plot/drawing_picture.hpp"
#include "host-sim/plot/edge_layer.hpp"
#include "host-sim/plot/pixel_image.hpp"
#include "host-sim/plot/svg_element.hpp"

namespace sim {
namespace {

using cut::Cut;
using cut::Purpose;
using cut::Stroke;
using drawing::Place;

constexpr std::string_view kEdgeColour = "#222222";
constexpr double kEdgePx = 1.2;

bool is_along(const Stroke& stroke) {
  return stroke.purpose == Purpose::kContour || stroke.purpose == Purpose::kSlice;
}
bool is_lead(const Stroke& stroke) { return !is_along(stroke) && has_beam(stroke.purpose); }
bool is_tab(const Stroke& stroke) { return stroke.purpose == Purpose::kTab; }
bool is_lit(const Stroke& stroke) { return has_beam(stroke.purpose); }

void add_stroke(std::string& data, const Stroke& stroke, bool joins, const View& view) {
  const double x_px = view.x_px(stroke.from.x());
  const double y_px = view.y_px(stroke.from.y());
  if (!joins) fmt::format_to(std::back_inserter(data), "M{:.2f} {:.2f}", x_px, y_px);
  svg::add_bulge(
      data, x_px, y_px, view.x_px(stroke.to.x()), view.y_px(stroke.to.y()), stroke.bulge);
}

void add_line(std::string& out, const std::string& data, std::string_view colour, double width_px) {
  if (data.empty()) return;
  fmt::format_to(std::back_inserter(out),
                 "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:.2f}\" "
                 "stroke-linecap=\"round\" stroke-linejoin=\"round\"/>\n",
                 data,
                 colour,
                 width_px);
}

/// Appends the pictures of the plan in the form in which they are engraved.
void add_pictures(std::string& out, const cut::CutPlan& plan, const View& view) {
  for (const Cut& cut : plan.cuts) {
    if (!cut.picture || cut.pass > 1) continue;
    const engrave::BurnRaster& raster = cut.picture->raster;
    const Place size{raster.pixel_mm * static_cast<double>(raster.columns),
                     raster.interval_mm * static_cast<double>(raster.rows)};
    const Place& at = cut.picture->at_mm;
    add_png(out,
            engrave::burn_picture(raster),
            {view.x_px(at.x()),
             view.y_px(at.y() + size.y()),
             size.x() * view.px_per_mm(),
             size.y() * view.px_per_mm()},
            Blend::kDarken);
  }
}

void add_beam(std::string& out, const cut::CutPlan& plan, const View& view) {
  for (const Cut& cut : plan.cuts) {
    if (cut.picture) continue;
    const double kerf_px = plan.plan_of(cut).condition.kerf_mm * view.px_per_mm();
    out += "<g opacity=\"0.6\">\n";
    add_line(out, path_data_of(cut, view, is_lit), kBandColour, kerf_px);
    out += "</g>\n";
  }
  for (const Cut& cut : plan.cuts) {
    if (cut.picture) continue;
    add_line(out, path_data_of(cut, view, is_along), kBeamColour, 1.4);
    add_line(out, path_data_of(cut, view, is_lead), kLeadColour, 2.0);
    add_line(out, path_data_of(cut, view, is_tab), kTabRim, kTabRimPx);
    add_line(out, path_data_of(cut, view, is_tab), kTabColour, kTabPx);
  }
}

/// Returns whether a contour is cut and therefore an edge of a part. Engraved and skipped contours
/// are no edges.
bool cuts_through(const cut::CutPlan& plan, std::size_t contour, std::size_t layer) {
  const cut::Side side = plan.recipes.of(contour, plan.layers[layer]).settings.side;
  return side == cut::Side::kWaste || side == cut::Side::kOn;
}

/// Appends the edges of the stock that a sheet file describes.
void add_stock(std::string& out, const drawing::Drawing& drawn, const View& view) {
  if (!drawn.stock) return;
  fmt::format_to(std::back_inserter(out),
                 "<rect class=\"stock\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" "
                 "height=\"{:.1f}\" fill=\"none\" stroke=\"#5b626c\" stroke-width=\"1.5\"/>\n",
                 view.x_px(0.0),
                 view.y_px(drawn.stock->height_mm),
                 drawn.stock->width_mm * view.px_per_mm(),
                 drawn.stock->height_mm * view.px_per_mm());
}

}  // namespace

Extent extent_of(const CutScene& scene) {
  Extent extent;
  for (const drawing::DrawnContour& contour : scene.drawn.contours) {
    for (const Place& place : outline_of(contour.shapes, drawing::kChordToleranceMm)) {
      extent.include(place.x(), place.y());
    }
  }
  constexpr int kLooks = 8;
  for (const Cut& cut : scene.plan.cuts) {
    for (const Stroke& stroke : cut.strokes) {
      for (int i = 0; i <= kLooks; ++i) {
        const Place place = place_at(stroke, static_cast<double>(i) / kLooks);
        extent.include(place.x(), place.y());
      }
    }
  }
  if (const auto& stock = scene.drawn.stock) {
    extent.include(0.0, 0.0);
    extent.include(stock->width_mm, stock->height_mm);
  }
  if (extent.is_empty()) extent.include(0.0, 0.0);
  return extent;
}

Extent framed_cuts(const Extent& extent) {
  const double size_mm = std::max({extent.width_mm(), extent.height_mm(), 1.0e-3});
  const double margin = 0.04 * size_mm;
  return {extent.left_mm - margin,
          extent.right_mm + margin,
          extent.bottom_mm - margin,
          extent.top_mm + margin};
}

void add_parts(std::string& out, const CutScene& scene, const View& view) {
  std::string edges;
  std::string others;
  for (std::size_t i = 0; i < scene.drawn.contours.size(); ++i) {
    const drawing::DrawnContour& contour = scene.drawn.contours[i];
    add_outline(cuts_through(scene.plan, i, contour.entity.layer) ? edges : others, contour, view);
  }
  add_line(out, others, kEdgeColour, kEdgePx);
  fmt::format_to(
      std::back_inserter(out),
      "<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" stroke=\"{}\" stroke-width=\"{:.1f}\"/>\n",
      edges,
      kPartColour,
      kEdgeColour,
      kEdgePx);
}

std::string path_data_of(const Cut& cut, const View& view, bool (*wanted)(const Stroke&)) {
  std::string data;
  bool joins = false;
  for (const Stroke& stroke : cut.strokes) {
    if (wanted(stroke)) add_stroke(data, stroke, joins, view);
    joins = wanted(stroke);
  }
  return data;
}

void add_cut_layers(std::string& out,
                    const CutScene& scene,
                    const View& view,
                    const cut::EdgeFigures* edges,
                    double edge_key_px) {
  add_stock(out, scene.drawn, view);
  add_parts(out, scene, view);
  if (scene.timeline != nullptr) {
    add_heat(out, scene.plan, heat_at_pierces(scene.plan, *scene.timeline), view);
  }
  add_pictures(out, scene.plan, view);
  add_beam(out, scene.plan, view);
  add_rapids(out, scene.plan, view);
  add_pierces(out, scene.plan, view);
  if (edges != nullptr) add_edges(out, *edges, view, edge_key_px);
  add_numbers(out, scene.plan, view);
}

}  // namespace sim
