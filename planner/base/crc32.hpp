#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cnc {

/// CRC-32 of IEEE 802.3, as in zlib and Ethernet: reflected polynomial 0xEDB88320, initial value
/// and result inverted. It detects every burst of up to 32 bits and, in data shorter than 11 KB,
/// any three wrong bits.
///
/// A step processes four digits with four independent table look-ups. A digit is a byte, or a
/// nibble on a controller.
class Crc32 {
 public:
  void add(std::byte byte);
  /// Adds the four bytes of a word, the lowest byte first.
  void add(std::uint32_t word);
  void add(std::span<const std::byte> bytes);
  /// Returns the CRC of all data added so far.
  [[nodiscard]] std::uint32_t value() const { return ~state_; }

 private:
  /// Returns the state after a step, which processes the lowest four digits of `mixed`. The higher
  /// digits of `mixed`, already combined with the following data, move down by four digits. The
  /// function is a member because the linker script places the sections of this class next to the
  /// image's start-up code.
  [[nodiscard]] static std::uint32_t after_step(std::uint32_t mixed);

  std::uint32_t state_ = 0xFFFF'FFFF;
};

}  // namespace cnc
