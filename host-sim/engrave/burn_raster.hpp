#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/import/place.hpp"
#include "host-sim/picture/grey_image.hpp"

namespace sim::engrave {

using picture::GreyImage;

/// Method that converts greys to powers.
enum class Shading : std::uint8_t {
  kGrey,       ///< Power depends on the grey, without dithering.
  kThreshold,  ///< Full power for pixels that are darker than 50 % grey.
  /// Full power for pixels that are darker than their threshold in an 8 x 8 Bayer matrix.
  kOrdered,
  /// Floyd and Steinberg: the error of each dot is distributed to four neighbouring pixels.
  kFloydSteinberg,
  kJarvis,  ///< Jarvis, Judice and Ninke: the error is distributed to twelve neighbouring pixels.
  kStucki,  ///< Stucki: as kJarvis, with different weights.
};

/// Conversion from greys to powers.
struct ToneCurve {
  Shading shading = Shading::kGrey;
  double min_power = 0.0;  ///< Power of the lightest grey that is burnt, as a share of full power.
  double max_power = 1.0;  ///< Power of black, as a share of full power.
  double gamma = 1.0;      ///< Exponent of the darkness. A value above 1 makes the picture lighter.
  bool is_inverted = false;
};

/// A picture as powers. Columns run along X. Rows are counted from the bottom.
struct BurnRaster {
  std::size_t columns = 0;
  std::size_t rows = 0;
  double pixel_mm = 0.1;     ///< Width of a pixel.
  double interval_mm = 0.1;  ///< Distance from row to row.
  std::vector<float> power;  ///< Power of each pixel, as a share of full power; 0: beam off.

  [[nodiscard]] float at(std::size_t column, std::size_t row) const {
    return power[row * columns + column];
  }
};

/// Darkness below which a pixel counts as white and is not burnt. It is half a step of 8 bits.
inline constexpr float kWhiteBelow = 0.5F / 255.0F;

/// Returns the power for a darkness without dithering: 0 for white; otherwise least power +
/// (greatest power - least power) · darkness^gamma.
[[nodiscard]] double power_of(double darkness, const ToneCurve& curve);

/// Returns a picture as powers, in a raster of `columns` by `rows` pixels. Each pixel has the mean
/// darkness of its area. Pixels that the picture does not cover have no power.
/// @pre columns and rows above 0
[[nodiscard]] BurnRaster burn_raster(const GreyImage& image,
                                     std::size_t columns,
                                     std::size_t rows,
                                     const ToneCurve& curve);

/// Returns a picture of the size `size_mm` as powers. The width of a pixel and the distance of rows
/// are as close to the required values as integer numbers of pixels and rows allow. Throws
/// std::invalid_argument if there are too many pixels.
/// @param size_mm above 0
/// @param interval_mm required distance of rows
/// @param pixel_mm required width of a pixel
[[nodiscard]] BurnRaster burn_raster(const GreyImage& image,
                                     const drawing::Place& size_mm,
                                     double interval_mm,
                                     double pixel_mm,
                                     const ToneCurve& curve);

}  // namespace sim::engrave
