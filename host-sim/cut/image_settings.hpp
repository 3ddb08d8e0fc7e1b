#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "host-sim/engrave/burn_raster.hpp"

namespace sim::cut {

/// Power as a share of the laser's, until its full power is known.
struct PowerShare {
  double value = 0.0;
  bool is_s = false;  ///< A value of S; else percent.
  bool operator==(const PowerShare&) const = default;
};

/// A power as it is said: watts, a share, or neither.
struct PowerWish {
  std::optional<double> watts{};
  std::optional<PowerShare> share{};
  bool operator==(const PowerWish&) const = default;
};

/// Reads `40W`, `40`, `60%` or `S600`. Throws std::invalid_argument with the key.
[[nodiscard]] PowerWish power_from(std::string_view key, std::string_view text);

/// How a picture of a layer is burnt; its interval and overscan are those of a filled layer.
struct ImageSettings {
  std::optional<double> pixel_mm{};  ///< Width of a pixel; none: as the interval.
  PowerWish least_power{};           ///< Power of the lightest grey; neither: 0.
  engrave::Shading shading = engrave::Shading::kGrey;
  double gamma = 1.0;  ///< Exponent of the darkness; above 1 is lighter.
  bool is_inverted = false;
  bool is_one_way = false;        ///< All rows are driven to the right.
  bool is_plain = false;          ///< One S to a line, as any Grbl reads.
  double reverse_shift_mm = 0.0;  ///< Added to X in rows that are driven to the left.
  bool operator==(const ImageSettings&) const = default;
};

/// Keys that only a layer of pictures has.
inline constexpr std::array<std::string_view, 8> kImageKeys{
    "min-power", "shading", "gamma", "invert", "pixel", "one-way", "plain", "reverse-shift"};

/// Takes one of these. Throws std::invalid_argument saying what is wrong.
/// @pre the key is one of kImageKeys
void set_image(ImageSettings& settings, std::string_view key, std::string_view value);

}  // namespace sim::cut
