#include "host-sim/plot/stock_picture.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/grid.hpp"
#include "host-sim/plot/legend.hpp"
#include "host-sim/plot/legend_content.hpp"
#include "host-sim/plot/picture.hpp"
#include "host-sim/plot/pixel_image.hpp"
#include "host-sim/plot/svg_element.hpp"
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
constexpr std::size_t kMaxPlanPixels = 2'000'000;
constexpr Colour kUncutColour{0xd9, 0xdc, 0xe0};
/// Depth below which a block of cells is drawn as uncut, mm.
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

/// Appends the plan as an image, with a pixel for each block of cells, and with Y upwards.
void add_plan(std::string& out,
              const std::string& file,
              const stock::HeightMap& map,
              double deepest_mm,
              const View& view) {
  PixelImage image{map.columns(), map.rows()};
  for (int row = 0; row < map.rows(); ++row) {
    for (int column = 0; column < map.columns(); ++column) {
      const double depth_mm = map.box().top - map.height(column, row);
      image.set(column,
                map.rows() - 1 - row,
                depth_mm <= kUncutMm ? kUncutColour : speed_colour(1.0 - depth_mm / deepest_mm));
    }
  }
  const stock::StockBox& box = map.box();
  const double left_px = view.x_px(box.x_min);
  const double top_px = view.y_px(box.y_max);
  add_image(out,
            file,
            image,
            {left_px, top_px, view.x_px(box.x_max) - left_px, view.y_px(box.y_min) - top_px});
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
  const stock::HeightMap map{carved, kMaxPlanPixels};
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
  add_plan(out, file, map, scale_mm, view);
  const Box legend_box{view.box().right_px() + kStockMarginPx,
                       view.box().top_px,
                       kStockLegendPx,
                       view.box().height_px};
  add_legend(out, legend_box, view, legend);
  return out + "</svg>\n";
}

}  // namespace sim
