#pragma once

#include <cstdint>
#include <string>

namespace sim {

struct Colour {
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;
};

/// The colour of a speed as a fraction of the scale, held constant outside 0…1.
///
/// From dark blue (slow) through magenta to orange (fast). Lightness rises all
/// the way, so the order survives colour blindness and grey printing, and ends
/// early enough to stay visible on white. Source: the map "plasma" of S. van der
/// Walt and N. Smith (matplotlib, CC0), its lower three quarters.
[[nodiscard]] Colour speed_colour(double fraction);

/// `#rrggbb`.
[[nodiscard]] std::string hex(const Colour& colour);

}  // namespace sim
