#include "host-sim/plot/stock_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/grid.hpp"
#include "host-sim/plot/legend.hpp"
#include "host-sim/plot/legend_content.hpp"
#include "host-sim/plot/picture.hpp"
#include "host-sim/plot/svg_element.hpp"
#include "host-sim/plot/svg_render.hpp"
#include "host-sim/stock/height_map.hpp"

namespace sim {
namespace {

constexpr double kStockLeftPx = 100.0;
constexpr double kStockHeadingPx = 128.0;
constexpr double kStockLegendPx = 270.0;
constexpr double kStockMarginPx = 40.0;
constexpr double kStockBottomPx = 84.0;
constexpr double kStockWidthPx =
    kPictureWidthPx - kStockLeftPx - kStockLegendPx - 2.0 * kStockMarginPx;
constexpr double kTallestStockPx = 1.15 * kStockWidthPx;
constexpr std::size_t kMostPlanPixels = 2'000'000;
constexpr Colour kUncutColour{0xd9, 0xdc, 0xe0};
/// Shallower, a block is uncut to the eye, mm.
constexpr double kUncutMm = 1.0e-4;

View view_of_stock(const stock::StockBox& box) {
  const double side_mm = std::max(box.x_max - box.x_min, box.y_max - box.y_min);
  const double margin_mm = 0.04 * side_mm;
  const Extent framed{
      box.x_min - margin_mm, box.x_max + margin_mm, box.y_min - margin_mm, box.y_max + margin_mm};
  const double natural_px = kStockWidthPx * framed.height_mm() / framed.width_mm();
  return View{framed,
              {kStockLeftPx,
               kStockHeadingPx,
               kStockWidthPx,
               std::clamp(natural_px, kLegendHeightPx, kTallestStockPx)}};
}

std::uint32_t pixel_of(const Colour& colour) {
  return static_cast<std::uint32_t>(colour.red) << 16U |
         static_cast<std::uint32_t>(colour.green) << 8U | colour.blue;
}

/// The plan as a PNG, a pixel for each block, Y upwards.
std::string plan_png(const std::string& file, const stock::HeightMap& map, double deepest_mm) {
  const CairoSurface surface{
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, map.columns(), map.rows())};
  unsigned char* const bytes = cairo_image_surface_get_data(surface.get());
  if (bytes == nullptr) fail_to_draw(file, "the stock has too many cells");
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int row = 0; row < map.rows(); ++row) {
    auto* const pixels = reinterpret_cast<std::uint32_t*>(
        bytes + static_cast<std::ptrdiff_t>(map.rows() - 1 - row) * stride);
    for (int column = 0; column < map.columns(); ++column) {
      const double depth_mm = map.box().top - map.height(column, row);
      pixels[column] =
          pixel_of(depth_mm <= kUncutMm ? kUncutColour : speed_colour(1.0 - depth_mm / deepest_mm));
    }
  }
  cairo_surface_mark_dirty(surface.get());
  std::string png;
  const cairo_status_t status =
      cairo_surface_write_to_png_stream(surface.get(), append_to_text, &png);
  if (status != CAIRO_STATUS_SUCCESS) fail_to_draw(file, cairo_status_to_string(status));
  return png;
}

std::string base64(const std::string& bytes) {
  gchar* const text = g_base64_encode(reinterpret_cast<const guchar*>(bytes.data()), bytes.size());
  std::string result{text};
  g_free(text);
  return result;
}

void add_plan(std::string& out,
              const std::string& png,
              const stock::StockBox& box,
              const View& view) {
  const double left_px = view.x_px(box.x_min);
  const double top_px = view.y_px(box.y_max);
  fmt::format_to(std::back_inserter(out),
                 R"(<image x="{:.3f}" y="{:.3f}" width="{:.3f}" height="{:.3f}" )"
                 R"(preserveAspectRatio="none" href="data:image/png;base64,{}"/>)"
                 "\n",
                 left_px,
                 top_px,
                 view.x_px(box.x_max) - left_px,
                 view.y_px(box.y_min) - top_px,
                 base64(png));
}

LegendContent legend_of(double deepest_mm) {
  LegendContent content{.shown = Shown::kDepth, .has_marks = false};
  if (deepest_mm <= kUncutMm) return content;
  content.tick_speed_mm_min = round_step(deepest_mm / 6.0);
  content.top_speed_mm_min =
      content.tick_speed_mm_min * std::ceil(deepest_mm / content.tick_speed_mm_min - 1.0e-6);
  return content;
}

}  // namespace

std::string draw_stock(const std::string& file,
                       const stock::Stock& carved,
                       const std::string& title,
                       const std::string& facts) {
  const stock::HeightMap map{carved, kMostPlanPixels};
  const View view = view_of_stock(carved.box());
  const double deepest_mm = carved.box().top - map.lowest();
  const LegendContent legend = legend_of(deepest_mm);
  const double scale_mm = std::max(legend.top_speed_mm_min, kUncutMm);
  const double height_px = view.box().bottom_px() + kStockBottomPx;
  std::string out = svg::document_start(kPictureWidthPx, height_px);
  svg::add_box(out, {0.0, 0.0, kPictureWidthPx, height_px}, "#ffffff");
  svg::add_text(out, kStockLeftPx, 58.0, {.size_px = 34.0, .weight = "bold"}, title);
  svg::add_text(out, kStockLeftPx, 96.0, {.size_px = 23.0, .fill = "#5b626c"}, facts);
  add_grid(out, view);
  add_plan(out, plan_png(file, map, scale_mm), carved.box(), view);
  const Box legend_box{view.box().right_px() + kStockMarginPx,
                       view.box().top_px,
                       kStockLegendPx,
                       view.box().height_px};
  add_legend(out, legend_box, view, legend);
  return out + "</svg>\n";
}

}  // namespace sim
