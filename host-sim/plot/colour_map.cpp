#include "host-sim/plot/colour_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace sim {
namespace {

constexpr std::array<Colour, 8> kTable{{
    {0x0d, 0x08, 0x87},
    {0x46, 0x03, 0x9f},
    {0x72, 0x01, 0xa8},
    {0x9c, 0x17, 0x9e},
    {0xbd, 0x37, 0x86},
    {0xd8, 0x57, 0x6b},
    {0xed, 0x79, 0x53},
    {0xfb, 0x9f, 0x3a},
}};

std::uint8_t between(std::uint8_t low, std::uint8_t high, double fraction) {
  return static_cast<std::uint8_t>(std::lround(low + fraction * (high - low)));
}

}  // namespace

Colour speed_colour(double fraction) {
  constexpr double kLast = static_cast<double>(kTable.size() - 1);
  const double place = kLast * std::clamp(fraction, 0.0, 1.0);
  const auto index = std::min(static_cast<std::size_t>(place), kTable.size() - 2);
  const double rest = place - static_cast<double>(index);
  const Colour& low = kTable[index];
  const Colour& high = kTable[index + 1];
  return {between(low.red, high.red, rest),
          between(low.green, high.green, rest),
          between(low.blue, high.blue, rest)};
}

std::string hex(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

}  // namespace sim
