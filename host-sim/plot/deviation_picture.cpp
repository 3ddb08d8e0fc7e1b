#include "host-sim/plot/deviation_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <vector>

#include "host-sim/plot/grid.hpp"
#include "host-sim/plot/picture.hpp"
#include "host-sim/plot/picture_key.hpp"
#include "host-sim/plot/pixel_image.hpp"
#include "host-sim/plot/svg_element.hpp"

namespace sim {
namespace {

using stock::DeviationMap;
using stock::StockBox;
using stock::SurfaceFigures;
using stock::WorstPlace;

constexpr double kMapLeftPx = 100.0;
constexpr double kMapTopPx = 128.0;
constexpr double kMapKeyPx = 330.0;
constexpr double kMapGapPx = 40.0;
constexpr double kMapBottomPx = 84.0;
constexpr double kMapWidthPx = kPictureWidthPx - kMapLeftPx - kMapKeyPx - 2.0 * kMapGapPx;
constexpr double kMinMapHeightPx = 760.0;
constexpr double kTallestMapPx = 1.15 * kMapWidthPx;
/// Greatest number of pixels along the longer side of the map.
constexpr int kMaxMapPixels = 2'000;
constexpr double kMinScaleMm = 1.0e-4;
/// Colours of material that is left (white to dark blue) and of gouges (white to dark red).
constexpr std::array<Colour, 4> kRestColours{
    {{0xff, 0xff, 0xff}, {0x9e, 0xca, 0xe1}, {0x31, 0x82, 0xbd}, {0x08, 0x30, 0x6b}}};
constexpr std::array<Colour, 4> kGougeColours{
    {{0xff, 0xff, 0xff}, {0xfc, 0x92, 0x72}, {0xde, 0x2d, 0x26}, {0x67, 0x00, 0x0d}}};

/// Returns the end of the colour scale, mm: a round number that at most 0.2 % of the distances
/// exceed.
double scale_of(const DeviationMap& map) {
  constexpr double kShare = 0.998;
  std::vector<float> sizes;
  for (const float off : map.off_mm) {
    if (!std::isnan(off)) sizes.push_back(std::abs(off));
  }
  if (sizes.empty()) return kMinScaleMm;
  const auto place =
      sizes.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(sizes.size() - 1));
  std::ranges::nth_element(sizes, place);
  return round_step(std::max(static_cast<double>(*place), kMinScaleMm));
}

/// Returns the distance that represents a block of cells: the greatest gouge if it is deeper than
/// the absolute mean distance, otherwise the mean distance.
double off_of(const DeviationMap& map, int column, int row, int block) {
  double sum = 0.0;
  double least = 0.0;
  int count = 0;
  for (int y = row; y < std::min(row + block, map.rows); ++y) {
    for (int x = column; x < std::min(column + block, map.columns); ++x) {
      const double off = static_cast<double>(map.at(x, y));
      if (std::isnan(off)) continue;
      sum += off;
      least = std::min(least, off);
      ++count;
    }
  }
  if (count == 0) return std::nan("");
  const double mean = sum / count;
  return least < -std::abs(mean) ? least : mean;
}

PixelImage image_of(const DeviationMap& map, double scale_mm) {
  const int block = (std::max(map.columns, map.rows) + kMaxMapPixels - 1) / kMaxMapPixels;
  PixelImage image{(map.columns + block - 1) / block, (map.rows + block - 1) / block};
  for (int row = 0; row < image.height(); ++row) {
    for (int column = 0; column < image.width(); ++column) {
      const double off = off_of(map, column * block, row * block, block);
      if (std::isnan(off)) continue;
      image.set(column, image.height() - 1 - row, deviation_colour(off / scale_mm));
    }
  }
  return image;
}

View view_of_map(const StockBox& box) {
  const double side_mm = std::max(box.x_max - box.x_min, box.y_max - box.y_min);
  const double margin_mm = 0.04 * side_mm;
  const Extent framed{
      box.x_min - margin_mm, box.x_max + margin_mm, box.y_min - margin_mm, box.y_max + margin_mm};
  const double natural_px = kMapWidthPx * framed.height_mm() / framed.width_mm();
  return View{
      framed,
      {kMapLeftPx, kMapTopPx, kMapWidthPx, std::clamp(natural_px, kMinMapHeightPx, kTallestMapPx)}};
}

void add_mark(std::string& out,
              const View& view,
              const WorstPlace& place,
              const std::string& name) {
  const double x_px = view.x_px(place.x_mm);
  const double y_px = view.y_px(place.y_mm);
  fmt::format_to(std::back_inserter(out),
                 R"(<circle cx="{0:.1f}" cy="{1:.1f}" r="11" fill="none" stroke="#ffffff" )"
                 R"(stroke-width="5"/><circle cx="{0:.1f}" cy="{1:.1f}" r="11" fill="none" )"
                 R"(stroke="#111111" stroke-width="2"/>)"
                 "\n",
                 x_px,
                 y_px);
  svg::add_rimmed_text(out, x_px + 15.0, y_px - 9.0, 20.0, name);
}

/// Marks points on the plan and lists them in the key of the picture.
void add_places(std::string& out,
                const View& view,
                const std::vector<WorstPlace>& places,
                char letter,
                PictureKey& key) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const WorstPlace& place = places[i];
    const std::string name = fmt::format("{}{}", letter, i + 1);
    add_mark(out, view, place, name);
    const std::string tool =
        place.unreachable_mm > 0.0 ? fmt::format(" ({:.4f})", place.unreachable_mm) : "";
    key.notes.push_back(fmt::format(
        "{} {:+.4f}{} X{:.1f} Y{:.1f}", name, place.off_mm, tool, place.x_mm, place.y_mm));
  }
}

PictureKey key_of(double scale_mm, const SurfaceFigures& figures) {
  PictureKey key;
  ColourScale scale{
      .heading = "Off the surface, mm", .colours = {}, .least = -scale_mm, .most = scale_mm};
  constexpr int kSteps = 58;
  for (int i = 0; i < kSteps; ++i)
    scale.colours.push_back(deviation_colour((2 * i + 1.0) / kSteps - 1.0));
  key.scales.push_back(std::move(scale));
  key.samples = {{.shape = SampleShape::kArea, .colour = "#3182bd", .label = "stock is left (R)"},
                 {.shape = SampleShape::kArea, .colour = "#de2d26", .label = "gouge (G)"}};
  key.notes = {"at right angles to the surface,",
               fmt::format("exact to half a cell of {:.3g} mm;", figures.cell_mm),
               "darkest: the scale's end or more",
               "(…): the tool does not fit",
               ""};
  return key;
}

}  // namespace

Colour deviation_colour(double share) {
  const std::array<Colour, 4>& table = share < 0.0 ? kGougeColours : kRestColours;
  constexpr double kLast = static_cast<double>(kRestColours.size() - 1);
  const double place = kLast * std::min(std::abs(share), 1.0);
  const auto index = std::min(static_cast<std::size_t>(place), table.size() - 2);
  const double rest = place - static_cast<double>(index);
  const auto between = [rest](std::uint8_t low, std::uint8_t high) {
    return static_cast<std::uint8_t>(std::lround(low + rest * (high - low)));
  };
  const Colour& low = table[index];
  const Colour& high = table[index + 1];
  return {between(low.red, high.red), between(low.green, high.green), between(low.blue, high.blue)};
}

std::string draw_deviation(const std::string& file,
                           const stock::SurfaceComparison& comparison,
                           const std::string& title,
                           const std::string& facts) {
  const DeviationMap& map = comparison.map;
  const StockBox& box = map.box;
  const View view = view_of_map(box);
  const double height_px = view.box().bottom_px() + kMapBottomPx;
  const double scale_mm = scale_of(map);
  PictureKey key = key_of(scale_mm, comparison.figures);
  std::string out = svg::document_start(kPictureWidthPx, height_px);
  svg::add_box(out, {0.0, 0.0, kPictureWidthPx, height_px}, "#ffffff");
  svg::add_text(out, kMapLeftPx, 58.0, {.size_px = 34.0, .weight = "bold"}, title);
  svg::add_text(out, kMapLeftPx, 96.0, {.size_px = 23.0, .fill = "#5b626c"}, facts);
  const Box plan{view.x_px(box.x_min),
                 view.y_px(box.y_max),
                 view.x_px(box.x_max) - view.x_px(box.x_min),
                 view.y_px(box.y_min) - view.y_px(box.y_max)};
  svg::add_box(out, plan, "#e4e6e9");
  add_image(out, file, image_of(map, scale_mm), plan);
  add_grid(out, view);
  add_places(out, view, comparison.figures.worst_gouges, 'G', key);
  add_places(out, view, comparison.figures.worst_rests, 'R', key);
  if (comparison.figures.worst_gouges.empty()) key.notes.emplace_back("no gouge");
  add_key(
      out, {view.box().right_px() + kMapGapPx, kMapTopPx, kMapKeyPx, view.box().height_px}, key);
  return out + "</svg>\n";
}

}  // namespace sim
