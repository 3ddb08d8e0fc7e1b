#pragma once

#include <cstdint>

namespace sim::drawing {

/// Returns a number that consists of the interleaved bits of both coordinates. Cells that are near
/// each other in the plane mostly have numbers that are near each other.
[[nodiscard]] inline std::uint64_t near_order(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint64_t bits) {
    bits = (bits | bits << 16U) & 0x0000'FFFF'0000'FFFFU;
    bits = (bits | bits << 8U) & 0x00FF'00FF'00FF'00FFU;
    bits = (bits | bits << 4U) & 0x0F0F'0F0F'0F0F'0F0FU;
    bits = (bits | bits << 2U) & 0x3333'3333'3333'3333U;
    return (bits | bits << 1U) & 0x5555'5555'5555'5555U;
  };
  return spread(x) << 1U | spread(y);
}

}  // namespace sim::drawing
