#include "host-sim/plot/drawing_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {
namespace {

using drawing::DrawnContour;
using drawing::Place;

constexpr double kSidePx = 1000.0;
constexpr double kDrawingMarginPx = 30.0;
constexpr double kChordPx = 0.1;
constexpr double kRingPx = 9.0;

/// Widens an extent, so that an empty drawing or a single point has an area that can be shown.
void widen(Extent& bounds) {
  if (bounds.is_empty()) bounds.include(0.0, 0.0);
  const double least = 1.0e-3;
  if (bounds.width_mm() < least) bounds.include(bounds.left_mm + least, bounds.bottom_mm);
  if (bounds.height_mm() < least) bounds.include(bounds.left_mm, bounds.bottom_mm + least);
}

Extent bounds_of(const drawing::Drawing& drawn) {
  Extent bounds;
  for (const DrawnContour& contour : drawn.contours) {
    for (const Place& place : outline_of(contour.shapes, drawing::kChordToleranceMm)) {
      bounds.include(place.x(), place.y());
    }
  }
  widen(bounds);
  return bounds;
}

void add_paths(std::string& out, const drawing::Drawing& drawn, const View& view) {
  std::string closed;
  std::string open;
  for (const DrawnContour& contour : drawn.contours) {
    add_outline(contour.closed ? closed : open, contour, view);
  }
  out += fmt::format("<path d=\"{}\" fill=\"#d6d2cb\" fill-rule=\"evenodd\" stroke=\"#222222\"/>\n",
                     closed);
  out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#b03030\" stroke-dasharray=\"6 4\"/>\n",
                     open);
}

/// Appends the number of each contour at the beginning of the contour. The numbers count from 1, as
/// in the listing of the drawing's contours.
void add_numbers_of(std::string& out, const drawing::Drawing& drawn, const View& view) {
  constexpr double kNumberPx = 14.0;
  for (std::size_t i = 0; i < drawn.contours.size(); ++i) {
    const auto places = outline_of(drawn.contours[i].shapes, kChordPx / view.px_per_mm());
    if (places.empty()) continue;
    svg::add_rimmed_text(out,
                         view.x_px(places.front().x()) + 4.0,
                         view.y_px(places.front().y()) - 4.0,
                         kNumberPx,
                         fmt::format("{}", i + 1));
  }
}

}  // namespace

void add_outline(std::string& data, const DrawnContour& contour, const View& view) {
  char letter = 'M';
  for (const Place& place : outline_of(contour.shapes, kChordPx / view.px_per_mm())) {
    fmt::format_to(std::back_inserter(data),
                   "{}{:.2f} {:.2f}",
                   letter,
                   view.x_px(place.x()),
                   view.y_px(place.y()));
    letter = 'L';
  }
  if (contour.closed) data += 'Z';
}

std::string draw_contours(const drawing::Drawing& drawn) {
  const Extent bounds = bounds_of(drawn);
  const double longest = std::max(bounds.width_mm(), bounds.height_mm());
  const double width = kSidePx * bounds.width_mm() / longest;
  const double height = kSidePx * bounds.height_mm() / longest;
  const View view{bounds, {kDrawingMarginPx, kDrawingMarginPx, width, height}};
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.1f}\" height=\"{1:.1f}\" viewBox=\"0 "
      "0 {0:.1f} {1:.1f}\" style=\"max-width:100%;max-height:100vh\" font-family=\"'DejaVu Sans', "
      "Verdana, sans-serif\">\n<title>{2}</title>\n",
      width + 2.0 * kDrawingMarginPx,
      height + 2.0 * kDrawingMarginPx,
      svg::escaped(drawn.file));
  add_paths(out, drawn, view);
  for (const drawing::Fault& fault : drawn.faults) {
    if (!fault.place_mm) continue;
    out += fmt::format(
        "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"none\" stroke=\"#d01010\" "
        "stroke-width=\"2\"><title>{}</title></circle>\n",
        view.x_px(fault.place_mm->x()),
        view.y_px(fault.place_mm->y()),
        kRingPx,
        svg::escaped(fault.reason));
  }
  add_numbers_of(out, drawn, view);
  return out + "</svg>\n";
}

}  // namespace sim
