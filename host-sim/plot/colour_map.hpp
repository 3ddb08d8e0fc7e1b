#pragma once

#include <cstdint>
#include <string>

namespace sim {

struct Colour {
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;
};

/// Returns the colour of a speed given as a fraction of the scale. The colour is constant below 0
/// and above 1.
///
/// The colours go from dark blue (slow) through magenta to orange (fast). Lightness rises
/// throughout, so that the order is visible to colour-blind people and in grey prints. The scale
/// ends early enough to stay visible on white. Source: the lower three quarters of the map "plasma"
/// of S. van der Walt and N. Smith (matplotlib, CC0).
[[nodiscard]] Colour speed_colour(double fraction);

/// Returns a colour as `#rrggbb`.
[[nodiscard]] std::string hex(const Colour& colour);

}  // namespace sim
