#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host-sim/import/place.hpp"
#include "host-sim/picture/grey_image.hpp"

namespace sim::engrave {

using picture::GreyImage;

/// How greys become powers.
enum class Shading : std::uint8_t {
  kGrey,            ///< Power by the grey.
  kThreshold,       ///< Full power where it is darker than a half.
  kOrdered,         ///< The same, with an 8 x 8 Bayer matrix.
  kFloydSteinberg,  ///< Errors go to four neighbours.
  kJarvis,          ///< Jarvis, Judice and Ninke: to twelve.
  kStucki,          ///< To twelve, with other weights.
};

/// The curve from greys to powers.
struct ToneCurve {
  Shading shading = Shading::kGrey;
  double least_power = 0.0;  ///< Share of full power of the lightest grey that is burnt.
  double most_power = 1.0;   ///< Share of full power of black.
  double gamma = 1.0;        ///< Exponent of the darkness; above 1 is lighter.
  bool is_inverted = false;
};

/// A picture as powers: columns along X, rows from the bottom.
struct BurnRaster {
  std::size_t columns = 0;
  std::size_t rows = 0;
  double pixel_mm = 0.1;     ///< Width of a pixel.
  double interval_mm = 0.1;  ///< From row to row.
  std::vector<float> power;  ///< Share of full power, 0 where the beam is off.

  [[nodiscard]] float at(std::size_t column, std::size_t row) const {
    return power[row * columns + column];
  }
};

/// Darkness below this is white, which is not burnt; half of a step of 8 bits.
inline constexpr float kWhiteBelow = 0.5F / 255.0F;

/// Returns the power of a darkness without dithering: 0 for white, else between the least and the
/// most power by (darkness)^gamma.
[[nodiscard]] double power_of(double darkness, const ToneCurve& curve);

/// Returns the picture as powers of pixels of a size: each pixel has the mean darkness of its area.
/// What the picture does not cover stays without power.
/// @pre columns and rows above 0
[[nodiscard]] BurnRaster burn_raster(const GreyImage& image,
                                     std::size_t columns,
                                     std::size_t rows,
                                     const ToneCurve& curve);

/// Returns the picture as powers in a size of its own, in pixels and rows as near to the wanted
/// ones as whole numbers of them allow. Throws std::invalid_argument where these are too many.
/// @param size_mm above 0
/// @param pixel_mm width of a pixel
[[nodiscard]] BurnRaster burn_raster(const GreyImage& image,
                                     const drawing::Place& size_mm,
                                     double interval_mm,
                                     double pixel_mm,
                                     const ToneCurve& curve);

}  // namespace sim::engrave
