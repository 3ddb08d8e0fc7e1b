#include "host-sim/engrave/burn_raster.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

namespace sim::engrave {
namespace {

/// The pixels of a picture that one pixel of the raster averages along a row or a column: index of
/// the first pixel of the picture, and the shares of this pixel and of the following pixels in the
/// mean.
struct Weight {
  std::size_t from = 0;
  std::vector<float> shares{};
};

/// Divides a length of `from` pixels into `to` pixels. Returns for each new pixel the old pixels
/// that it covers, with their shares by length.
std::vector<Weight> weights(std::size_t from, std::size_t to) {
  std::vector<Weight> result(to);
  const double step = static_cast<double>(from) / static_cast<double>(to);
  for (std::size_t i = 0; i < to; ++i) {
    const double begin = step * static_cast<double>(i);
    const double end = std::min(step * static_cast<double>(i + 1), static_cast<double>(from));
    Weight& weight = result[i];
    weight.from = std::min(static_cast<std::size_t>(begin), from - 1);
    for (std::size_t k = weight.from; k < from && static_cast<double>(k) < end; ++k) {
      const double low = std::max(begin, static_cast<double>(k));
      const double high = std::min(end, static_cast<double>(k + 1));
      weight.shares.push_back(static_cast<float>((high - low) / step));
    }
    if (weight.shares.empty()) weight.shares.push_back(1.0F);
  }
  return result;
}

/// Returns for each pixel of the raster the mean of `values` within its area. `values` has one
/// value for each pixel of the picture. Rows are counted from the top.
std::vector<float> resampled(const GreyImage& image,
                             const std::vector<float>& values,
                             std::size_t columns,
                             std::size_t rows) {
  const std::vector<Weight> across = weights(image.width, columns);
  const std::vector<Weight> down = weights(image.height, rows);
  std::vector<float> result(columns * rows, 0.0F);
  std::vector<float> row(image.width);
  for (std::size_t y = 0; y < rows; ++y) {
    std::ranges::fill(row, 0.0F);
    for (std::size_t k = 0; k < down[y].shares.size(); ++k) {
      const float share = down[y].shares[k];
      const float* source = &values[(down[y].from + k) * image.width];
      for (std::size_t x = 0; x < image.width; ++x) row[x] += share * source[x];
    }
    for (std::size_t x = 0; x < columns; ++x) {
      float sum = 0.0F;
      for (std::size_t k = 0; k < across[x].shares.size(); ++k) {
        sum += across[x].shares[k] * row[across[x].from + k];
      }
      result[y * columns + x] = std::clamp(sum, 0.0F, 1.0F);
    }
  }
  return result;
}

/// A neighbour of a dot that receives a share of the dot's error.
struct Spread {
  int right = 0;
  int down = 0;
  float share = 0.0F;
};

constexpr std::array<Spread, 4> kFloydSteinbergSpread{
    {{1, 0, 7.0F / 16.0F}, {-1, 1, 3.0F / 16.0F}, {0, 1, 5.0F / 16.0F}, {1, 1, 1.0F / 16.0F}}};
constexpr std::array<Spread, 12> kJarvisSpread{{{1, 0, 7.0F / 48.0F},
                                                {2, 0, 5.0F / 48.0F},
                                                {-2, 1, 3.0F / 48.0F},
                                                {-1, 1, 5.0F / 48.0F},
                                                {0, 1, 7.0F / 48.0F},
                                                {1, 1, 5.0F / 48.0F},
                                                {2, 1, 3.0F / 48.0F},
                                                {-2, 2, 1.0F / 48.0F},
                                                {-1, 2, 3.0F / 48.0F},
                                                {0, 2, 5.0F / 48.0F},
                                                {1, 2, 3.0F / 48.0F},
                                                {2, 2, 1.0F / 48.0F}}};
constexpr std::array<Spread, 12> kStuckiSpread{{{1, 0, 8.0F / 42.0F},
                                                {2, 0, 4.0F / 42.0F},
                                                {-2, 1, 2.0F / 42.0F},
                                                {-1, 1, 4.0F / 42.0F},
                                                {0, 1, 8.0F / 42.0F},
                                                {1, 1, 4.0F / 42.0F},
                                                {2, 1, 2.0F / 42.0F},
                                                {-2, 2, 1.0F / 42.0F},
                                                {-1, 2, 2.0F / 42.0F},
                                                {0, 2, 4.0F / 42.0F},
                                                {1, 2, 2.0F / 42.0F},
                                                {2, 2, 1.0F / 42.0F}}};

std::span<const Spread> spread_of(Shading shading) {
  if (shading == Shading::kFloydSteinberg) return kFloydSteinbergSpread;
  return shading == Shading::kJarvis ? std::span<const Spread>{kJarvisSpread}
                                     : std::span<const Spread>{kStuckiSpread};
}

/// Converts greys to dots by error diffusion: the error of each dot is distributed to its
/// neighbours. The direction alternates from row to row.
void diffuse(std::vector<float>& grey, std::size_t columns, std::size_t rows, Shading shading) {
  const auto width = static_cast<int>(columns);
  const auto height = static_cast<int>(rows);
  const std::span<const Spread> spread = spread_of(shading);
  const auto index = [columns](int x, int y) {
    return static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x);
  };
  for (int y = 0; y < height; ++y) {
    const int way = y % 2 == 0 ? 1 : -1;
    for (int i = 0; i < width; ++i) {
      const int x = way > 0 ? i : width - 1 - i;
      float& pixel = grey[index(x, y)];
      const float dot = pixel >= 0.5F ? 1.0F : 0.0F;
      const float error = pixel - dot;
      pixel = dot;
      for (const Spread& each : spread) {
        const int column = x + way * each.right;
        if (column < 0 || column >= width || y + each.down >= height) continue;
        grey[index(column, y + each.down)] += error * each.share;
      }
    }
  }
}

/// Returns the threshold of a pixel in the 8 x 8 matrix of Bayer, above 0 and below 1.
float bayer_threshold(std::size_t x, std::size_t y) {
  std::uint32_t value = 0;
  for (std::uint32_t bit = 0; bit < 3; ++bit) {
    const auto low_x = static_cast<std::uint32_t>(x >> bit) & 1U;
    const auto low_y = static_cast<std::uint32_t>(y >> bit) & 1U;
    value = (value << 2U) | ((low_x ^ low_y) << 1U) | low_y;
  }
  return (static_cast<float>(value) + 0.5F) / 64.0F;
}

void make_dots(std::vector<float>& grey, std::size_t columns, std::size_t rows, Shading shading) {
  if (shading != Shading::kThreshold && shading != Shading::kOrdered) {
    return diffuse(grey, columns, rows, shading);
  }
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const float threshold = shading == Shading::kOrdered ? bayer_threshold(x, y) : 0.5F;
      float& pixel = grey[y * columns + x];
      pixel = pixel >= threshold ? 1.0F : 0.0F;
    }
  }
}

/// Inverts greys within the area that the picture covers.
void invert(const GreyImage& image,
            std::size_t columns,
            std::size_t rows,
            std::vector<float>& grey) {
  std::vector<float> cover(grey.size(), 1.0F);
  if (!image.cover.empty()) cover = resampled(image, image.cover, columns, rows);
  for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = std::max(0.0F, cover[i] - grey[i]);
}

}  // namespace

double power_of(double darkness, const ToneCurve& curve) {
  if (darkness < static_cast<double>(kWhiteBelow)) return 0.0;
  return curve.min_power +
         (curve.max_power - curve.min_power) * std::pow(std::min(darkness, 1.0), curve.gamma);
}

BurnRaster burn_raster(const GreyImage& image,
                       std::size_t columns,
                       std::size_t rows,
                       const ToneCurve& curve) {
  std::vector<float> grey = resampled(image, image.darkness, columns, rows);
  if (curve.is_inverted) invert(image, columns, rows, grey);
  const bool has_dots = curve.shading != Shading::kGrey;
  if (has_dots) {
    for (float& pixel : grey) {
      pixel = static_cast<float>(std::pow(static_cast<double>(pixel), curve.gamma));
    }
    make_dots(grey, columns, rows, curve.shading);
  }
  BurnRaster raster{.columns = columns, .rows = rows, .power = std::vector<float>(grey.size())};
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const auto darkness = static_cast<double>(grey[(rows - 1 - y) * columns + x]);
      const double power = has_dots ? darkness * curve.max_power : power_of(darkness, curve);
      raster.power[y * columns + x] = static_cast<float>(power);
    }
  }
  return raster;
}

BurnRaster burn_raster(const GreyImage& image,
                       const drawing::Place& size_mm,
                       double interval_mm,
                       double pixel_mm,
                       const ToneCurve& curve) {
  const double columns = std::max(1.0, std::round(size_mm.x() / pixel_mm));
  const double rows = std::max(1.0, std::round(size_mm.y() / interval_mm));
  if (columns * rows > static_cast<double>(picture::kMaxImagePixels)) {
    throw std::invalid_argument(
        fmt::format("{} x {} pixels would be burnt, but only {} are possible; make the picture "
                    "smaller or the interval greater",
                    columns,
                    rows,
                    picture::kMaxImagePixels));
  }
  BurnRaster raster =
      burn_raster(image, static_cast<std::size_t>(columns), static_cast<std::size_t>(rows), curve);
  raster.pixel_mm = size_mm.x() / columns;
  raster.interval_mm = size_mm.y() / rows;
  return raster;
}

}  // namespace sim::engrave
