#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cnc {

/// CRC-32 of IEEE 802.3, as in zlib and Ethernet: reflected polynomial 0xEDB88320, begun and ended
/// inverted. Finds every burst of up to 32 bits and, in what is below 11 KB, any three wrong bits.
///
/// Four look-ups, a byte each, or a nibble on a controller, do not wait for each other.
class Crc32 {
 public:
  void add(std::byte byte);
  /// Four bytes, the lowest first.
  void add(std::uint32_t word);
  void add(std::span<const std::byte> bytes);
  /// Of all that was added so far.
  [[nodiscard]] std::uint32_t value() const { return ~state_; }

 private:
  /// Returns the state after its lowest four digits; the others, which already hold the data that
  /// follow, move down. A member, because the image's start-up code has the sections of this class
  /// beside it.
  [[nodiscard]] static std::uint32_t after_step(std::uint32_t mixed);

  std::uint32_t state_ = 0xFFFF'FFFF;
};

}  // namespace cnc
