#pragma once

#include <cstdint>
#include <string>

namespace sim {

struct Colour {
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;
};

/// Returns the colour of a speed, which is given as a fraction of the colour scale. The colour is
/// constant below 0 and above 1.
///
/// The colours go from dark blue (slow) through magenta to orange (fast). Lightness increases along
/// the complete scale, so that the order of speeds is visible to colour-blind people and in grey
/// prints. The lightest colour is still visible on white. Source: the lower three quarters of the
/// map "plasma" of S. van der Walt and N. Smith (matplotlib, CC0).
[[nodiscard]] Colour speed_colour(double fraction);

/// Returns a colour as `#rrggbb`.
[[nodiscard]] std::string hex(const Colour& colour);

}  // namespace sim
