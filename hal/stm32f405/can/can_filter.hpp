#pragma once

#include <cstdint>

#include "hal/interface/can_port.hpp"
#include "hal/stm32f405/can/can_registers.hpp"

namespace hal::stm32f405 {

/// One bank of the receive filter: the frames that are accepted, and the FIFO that takes them.
/// Urgent frames go into one FIFO and the data stream into the other, so that neither waits for
/// free space in the other's FIFO.
struct CanFilter {
  enum class Kind : std::uint8_t {
    kMask,  ///< Data and remote frames whose bits agree with `id` where `other` has ones.
    kList,  ///< Data frames with identifier `id` or `other`.
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

/// Returns the second word of a filter bank.
constexpr Word second_word(const CanFilter& filter) {
  const bool list = filter.kind == CanFilter::Kind::kList;
  // A mask always distinguishes frames of 11 bits from those of 29.
  return can_identifier(filter.other, filter.extended, false) | (list ? 0 : bxcan::kExtended);
}

}  // namespace hal::stm32f405
