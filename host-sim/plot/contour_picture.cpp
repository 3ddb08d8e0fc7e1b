#include "host-sim/plot/contour_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/grid.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {
namespace {

constexpr double kContourWidthPx = 1600.0;
constexpr double kContourMarginPx = 90.0;
constexpr double kContourHeadingPx = 100.0;
constexpr double kTallestContourPx = 1600.0;
constexpr std::string_view kInputFill = R"(fill="#eef0f3" stroke="#5b626c" stroke-width="2.4")";

void include(Extent& extent, const Contour& contour) {
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    const std::uint32_t first = contour.view().loop_begin(loop);
    for (std::uint32_t i = first; i < contour.loop_ends[loop]; ++i) {
      const ContourVertex& from = contour.vertices[i];
      const ContourVertex& to = contour.vertices[i + 1 < contour.loop_ends[loop] ? i + 1 : first];
      // The extent includes a rectangle over the chord with the height of the arc. For an arc of
      // more than half a turn, the rectangle is wider than the chord.
      const double out_x = 0.5 * from.bulge * (to.y - from.y);
      const double out_y = -0.5 * from.bulge * (to.x - from.x);
      const double aside = std::abs(from.bulge) > 1.0 ? std::hypot(out_x, out_y) : 0.0;
      for (const ContourVertex& end : {from, to}) {
        extent.include(end.x, end.y);
        extent.include(end.x + out_x - aside, end.y + out_y - aside);
        extent.include(end.x + out_x + aside, end.y + out_y + aside);
      }
    }
  }
}

void add_element(std::string& out,
                 const ContourVertex& from,
                 const ContourVertex& to,
                 const View& view) {
  svg::add_bulge(
      out, view.x_px(from.x), view.y_px(from.y), view.x_px(to.x), view.y_px(to.y), from.bulge);
}

void add_contour(std::string& out,
                 const Contour& contour,
                 const View& view,
                 std::string_view attributes) {
  fmt::format_to(std::back_inserter(out), R"(<path {} fill-rule="evenodd" d=")", attributes);
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    const std::uint32_t first = contour.view().loop_begin(loop);
    const std::uint32_t end = contour.loop_ends[loop];
    const ContourVertex& start = contour.vertices[first];
    fmt::format_to(
        std::back_inserter(out), "M{:.2f} {:.2f}", view.x_px(start.x), view.y_px(start.y));
    for (std::uint32_t i = first; i < end; ++i) {
      add_element(out, contour.vertices[i], contour.vertices[i + 1 < end ? i + 1 : first], view);
    }
    out += 'Z';
  }
  out += "\"/>\n";
}

View view_of(const Extent& extent) {
  const double size_mm = std::max({extent.width_mm(), extent.height_mm(), 1.0e-3});
  const Extent framed{extent.left_mm - 0.04 * size_mm,
                      extent.right_mm + 0.04 * size_mm,
                      extent.bottom_mm - 0.04 * size_mm,
                      extent.top_mm + 0.04 * size_mm};
  const double width_px = kContourWidthPx - 2.0 * kContourMarginPx;
  const double natural_px = width_px * framed.height_mm() / framed.width_mm();
  return View{framed,
              {kContourMarginPx,
               kContourHeadingPx,
               width_px,
               std::clamp(natural_px, 200.0, kTallestContourPx)}};
}

/// Returns the start of a picture: its frame and the grid, over which the other content is drawn.
std::string begin_picture(const View& view, const std::string& title) {
  const double height_px = view.box().bottom_px() + kContourMarginPx;
  std::string out = svg::document_start(kContourWidthPx, height_px);
  svg::add_box(out, {0.0, 0.0, kContourWidthPx, height_px}, "#ffffff");
  svg::add_text(out, kContourMarginPx, 60.0, {.size_px = 34.0, .weight = "bold"}, title);
  add_grid(out, view);
  return out;
}

using PathPoint = cnc::pocket::PathPoint<double>;

/// Returns the style of an element of a tool path.
/// @param floor_mm lowest height of the path
std::string style_of(const PathPoint& from, double floor_mm) {
  using cnc::pocket::Use;
  switch (from.use) {
    case Use::kLink:
    case Use::kReturn:
    case Use::kLeadIn:
    case Use::kLeadOut:
      return R"(stroke="#9aa1ab" stroke-width="1.2" stroke-dasharray="6 5")";
    case Use::kEntry:
      return R"(stroke="#12813f" stroke-width="1.6")";
    case Use::kPass:
    case Use::kLight:
      break;
  }
  const double share = floor_mm < 0.0 ? std::clamp(from.z / floor_mm, 0.0, 1.0) : 1.0;
  return fmt::format(R"(stroke="{}" stroke-width="2.0")", hex(speed_colour(share)));
}

/// Appends a row of path points. Consecutive elements of the same style become one SVG path.
void add_row(std::string& out,
             cnc::contour::Slice<const PathPoint> row,
             double floor_mm,
             const View& view) {
  std::string style;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    if (row[i].point() == row[i + 1].point()) continue;
    const std::string next = style_of(row[i], floor_mm);
    if (next != style) {
      if (!style.empty()) out += "\"/>\n";
      fmt::format_to(std::back_inserter(out),
                     R"(<path fill="none" {} d="M{:.2f} {:.2f})",
                     next,
                     view.x_px(row[i].x),
                     view.y_px(row[i].y));
      style = next;
    }
    add_element(out, {row[i].x, row[i].y, row[i].bulge}, {row[i + 1].x, row[i + 1].y, 0.0}, view);
  }
  if (!style.empty()) out += "\"/>\n";
}

}  // namespace

std::string draw_contours(const Contour& input,
                          const std::vector<Contour>& offsets,
                          const std::string& title) {
  Extent extent;
  include(extent, input);
  for (const Contour& contour : offsets) include(extent, contour);
  const View view = view_of(extent);
  std::string out = begin_picture(view, title);
  add_contour(out, input, view, kInputFill);
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(offsets.size());
    add_contour(
        out,
        offsets[i],
        view,
        fmt::format(R"(fill="none" stroke="{}" stroke-width="2.4")", hex(speed_colour(share))));
  }
  return out + "</svg>\n";
}

std::string draw_tool_path(const Contour& walls,
                           const cnc::pocket::ToolPathView<double>& path,
                           const std::string& title) {
  Extent extent;
  include(extent, walls);
  const View view = view_of(extent);
  double floor_mm = 0.0;
  for (const PathPoint& point : path.points) floor_mm = std::min(floor_mm, point.z);
  std::string out = begin_picture(view, title);
  add_contour(out, walls, view, kInputFill);
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    const std::uint32_t begin = path.row_begin(row);
    add_row(out, {path.points.begin() + begin, path.row_ends[row] - begin}, floor_mm, view);
  }
  return out + "</svg>\n";
}

}  // namespace sim
