#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "host-sim/engrave/burn_raster.hpp"

namespace sim::cut {

/// A power that is given as a share of the laser's full power. It is used until this full power is
/// known.
struct PowerShare {
  double value = 0.0;
  bool is_s = false;  ///< Whether the value is an S value; otherwise it is a percentage.
  bool operator==(const PowerShare&) const = default;
};

/// A power as the user gives it: in watts or as a share. Both are empty if the user gives none.
struct PowerWish {
  std::optional<double> watts{};
  std::optional<PowerShare> share{};
  bool operator==(const PowerWish&) const = default;
};

/// Reads a power such as `40W`, `40`, `60%` or `S600`. Throws std::invalid_argument with the key
/// for any other text.
[[nodiscard]] PowerWish power_from(std::string_view key, std::string_view text);

/// Settings by which a layer's pictures are burnt. Interval and overscan are in FillSettings.
struct ImageSettings {
  std::optional<double> pixel_mm{};  ///< Width of a pixel; without a value, it equals the interval.
  /// Power of the lightest grey; 0 if both members are empty.
  PowerWish min_power{};
  engrave::Shading shading = engrave::Shading::kGrey;
  double gamma = 1.0;  ///< Exponent of the darkness; a value above 1 makes the picture lighter.
  bool is_inverted = false;
  bool is_one_way = false;  ///< Whether all rows are driven to the right.
  bool is_plain = false;    ///< Whether each line has at most one S word, as every Grbl requires.
  /// Distance by which X is shifted in rows that are driven to the left.
  double reverse_shift_mm = 0.0;
  bool operator==(const ImageSettings&) const = default;
};

/// Keys that are valid only for a layer of pictures.
inline constexpr std::array<std::string_view, 8> kImageKeys{
    "min-power", "shading", "gamma", "invert", "pixel", "one-way", "plain", "reverse-shift"};

/// Sets the setting of one of kImageKeys. Throws std::invalid_argument if the value is not valid.
/// @pre the key is one of kImageKeys
void set_image(ImageSettings& settings, std::string_view key, std::string_view value);

}  // namespace sim::cut
