#include "host-sim/plot/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "host-sim/plot/grid.hpp"
#include "host-sim/plot/legend.hpp"
#include "host-sim/plot/legend_content.hpp"
#include "host-sim/plot/path_drawing.hpp"
#include "host-sim/plot/path_simplifier.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/plot/view.hpp"
#include "host-sim/report/duration_text.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

constexpr double kMarginPx = 40.0;
constexpr double kHeadingHeightPx = 128.0;
constexpr double kLeftLabelsPx = 100.0;
constexpr double kBottomLabelsPx = 84.0;
constexpr double kLegendWidthPx = 270.0;
constexpr double kPlotWidthPx = kPictureWidthPx - kLeftLabelsPx - kLegendWidthPx - 2.0 * kMarginPx;
constexpr double kTallestPlotPx = 1.15 * kPlotWidthPx;

/// Distance below which points look like one point, so that a second point would only add bytes.
constexpr double kInvisiblePx = 0.1;

/// Returns the visible area: an extent with additional space for the width of lines. It always has
/// a width and a height.
Extent framed(const Extent& extent) {
  const double size_mm = std::max(extent.width_mm(), extent.height_mm());
  if (extent.is_empty()) return {-11.0, 11.0, -5.5, 5.5};
  const double margin_mm = size_mm > 0.0 ? 0.04 * size_mm : 5.5;
  // An extent that is a single point gets a wide frame.
  const double more_x_mm = size_mm > 0.0 ? 0.0 : margin_mm;
  return {extent.left_mm - margin_mm - more_x_mm,
          extent.right_mm + margin_mm + more_x_mm,
          extent.bottom_mm - margin_mm,
          extent.top_mm + margin_mm};
}

Box plot_box(const Extent& bounds) {
  const double natural_px = kPlotWidthPx * bounds.height_mm() / bounds.width_mm();
  return {kLeftLabelsPx,
          kHeadingHeightPx,
          kPlotWidthPx,
          std::clamp(natural_px, kLegendHeightPx, kTallestPlotPx)};
}

bool has(const std::vector<PathVertex>& vertices, Move move) {
  const auto is_such = [move](const PathVertex& vertex) { return vertex.move == move; };
  return !vertices.empty() && std::any_of(vertices.begin() + 1, vertices.end(), is_such);
}

double length_mm(const std::vector<PathVertex>& vertices, Move move) {
  double sum_mm = 0.0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    if (vertices[i].move != move) continue;
    sum_mm += std::hypot(vertices[i].x_mm - vertices[i - 1].x_mm,
                         vertices[i].y_mm - vertices[i - 1].y_mm);
  }
  return sum_mm;
}

std::string length_text(double mm) {
  return mm < 1000.0 ? fmt::format("{:.1f} mm", mm) : fmt::format("{:.2f} m", mm / 1000.0);
}

/// Returns a text with the dimensions of the cuts (or of all motion if nothing is cut), the length
/// of the cuts, and the time.
std::string subtitle_of(const Path& path, double cut_length_mm) {
  const bool has_cut = has(path.vertices, Move::kCut);
  const Extent part = bounds_of(path.vertices, has_cut ? Move::kCut : Move::kTravel);
  if (part.width_mm() + part.height_mm() == 0.0) return duration_text(path.duration_s);
  std::string text = fmt::format("{:.1f} × {:.1f} mm", part.width_mm(), part.height_mm());
  const double cut_mm = cut_length_mm >= 0.0 ? cut_length_mm : length_mm(path.vertices, Move::kCut);
  if (has_cut) text += "  ·  " + length_text(cut_mm) + " cut";
  return text + "  ·  " + duration_text(path.duration_s);
}

void add_heading(std::string& out, const Path& path, const PictureOptions& options) {
  const std::string& title = options.title;
  const std::string_view name = title.empty() ? std::string_view{"Path"} : title;
  const svg::TextStyle bold{.size_px = 34.0, .weight = "bold"};
  svg::add_text(out, kLeftLabelsPx, 58.0, bold, name);
  const svg::TextStyle grey{.size_px = 23.0, .fill = "#5b626c"};
  svg::add_text(out, kLeftLabelsPx, 96.0, grey, subtitle_of(path, options.cut_length_mm));
}

void add_marks(std::string& out, const std::vector<PathVertex>& vertices, const View& view) {
  const PathVertex& start = vertices.front();
  const PathVertex& end = vertices.back();
  add_start_mark(out, view.x_px(start.x_mm), view.y_px(start.y_mm));
  add_end_mark(out, view.x_px(end.x_mm), view.y_px(end.y_mm));
}

void add_no_motion(std::string& out, const Box& box, bool in_any_axis) {
  svg::add_text(out,
                box.left_px + 0.5 * box.width_px,
                box.top_px + 0.5 * box.height_px - 30.0,
                {.size_px = 26.0, .anchor = "middle", .fill = "#5b626c"},
                in_any_axis ? "no motion" : "no motion in X and Y");
}

/// Appends the path with its marks of start and end, and the legend next to it.
void add_motion(std::string& out,
                const std::vector<PathVertex>& vertices,
                const View& view,
                double kerf_width_mm,
                Shown shown) {
  const Box& box = view.box();
  const LegendContent legend = legend_content(vertices, kerf_width_mm, view.px_per_mm(), shown);
  const double top_mm_s = legend.top_speed_mm_min * legend_unit(shown);
  const PathTolerance invisible{.distance_mm = kInvisiblePx / view.px_per_mm(),
                                .speed_mm_s = static_cast<float>(top_mm_s / 64.0)};
  add_path(out, simplified(vertices, invisible), view, {kerf_width_mm, top_mm_s, shown});
  add_marks(out, vertices, view);
  const Box legend_box{box.right_px() + kMarginPx, box.top_px, kLegendWidthPx, box.height_px};
  add_legend(out, legend_box, view, legend);
}

}  // namespace

std::string draw_svg(const Path& path, const PictureOptions& options) {
  const Extent extent = bounds_of(path.vertices, Move::kTravel);
  const Extent bounds = framed(extent);
  const View view{bounds, plot_box(bounds)};
  const double height_px = view.box().bottom_px() + kBottomLabelsPx;

  std::string out = svg::document_start(kPictureWidthPx, height_px);
  svg::add_box(out, {0.0, 0.0, kPictureWidthPx, height_px}, "#ffffff");
  add_heading(out, path, options);
  add_grid(out, view);
  const bool moves_in_plane = extent.width_mm() + extent.height_mm() > 0.0;
  if (!moves_in_plane) add_no_motion(out, view.box(), path.vertices.empty());
  if (!path.vertices.empty()) {
    add_motion(out, path.vertices, view, options.kerf_width_mm, path.shown);
  }
  return out + "</svg>\n";
}

void write_svg(const std::string& file, const Path& path, const PictureOptions& options) {
  write_file(file, draw_svg(path, options));
}

}  // namespace sim
