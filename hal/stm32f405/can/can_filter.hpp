#pragma once

#include <cstdint>

#include "hal/interface/can_port.hpp"
#include "hal/stm32f405/can/can_registers.hpp"

namespace hal::stm32f405 {

/// One bank of the receive filter: selects frames, and the FIFO that receives them. Urgent frames
/// go into one FIFO and the data stream into the other, so that neither fills the FIFO of the
/// other.
struct CanFilter {
  enum class Kind : std::uint8_t {
    /// Data and remote frames whose identifier equals `id` in the bits that are 1 in `other`.
    kMask,
    kList,  ///< Data frames with the identifier `id` or `other`.
  };

  Kind kind = Kind::kMask;
  std::uint8_t fifo = 0;
  bool extended = false;
  std::uint32_t id = 0;
  std::uint32_t other = 0;
};

/// Returns an identifier in the bit layout of frames, mailboxes and filters.
constexpr Word can_identifier(std::uint32_t id, bool extended, bool remote) {
  return (extended ? (id & 0x1FFF'FFFFU) << 3 | bxcan::kExtended : (id & 0x7FFU) << 21) |
         (remote ? bxcan::kRemote : 0);
}

/// Returns the second word of a filter bank: the mask, or the second identifier.
constexpr Word second_word(const CanFilter& filter) {
  const bool list = filter.kind == CanFilter::Kind::kList;
  // A mask always distinguishes frames of 11 bits from frames of 29 bits.
  return can_identifier(filter.other, filter.extended, false) | (list ? 0 : bxcan::kExtended);
}

}  // namespace hal::stm32f405
