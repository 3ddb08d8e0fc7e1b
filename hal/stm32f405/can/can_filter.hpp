#pragma once

#include <cstdint>

#include "hal/interface/can_port.hpp"
#include "hal/stm32f405/can/can_registers.hpp"

namespace hal::stm32f405 {

/// Which frames are taken, and into which of the two FIFOs: what matters at once into
/// one, the stream into the other, so neither waits for the other's room. One bank.
struct CanFilter {
  enum class Kind : std::uint8_t {
    kMask,  ///< Data and remote frames that agree with `id` where `other` has ones.
    kList,  ///< Data frames that are `id` or `other`.
  };

  Kind kind = Kind::kMask;
  std::uint8_t fifo = 0;
  bool extended = false;
  std::uint32_t id = 0;
  std::uint32_t other = 0;
};

/// An identifier where frames, mailboxes and filters have it.
constexpr Word can_identifier(std::uint32_t id, bool extended, bool remote) {
  return (extended ? (id & 0x1FFF'FFFFU) << 3 | bxcan::kExtended : (id & 0x7FFU) << 21) |
         (remote ? bxcan::kRemote : 0);
}

/// The second word of a filter's bank.
constexpr Word second_word(const CanFilter& filter) {
  const bool list = filter.kind == CanFilter::Kind::kList;
  // A mask always tells frames of 11 bits from those of 29.
  return can_identifier(filter.other, filter.extended, false) | (list ? 0 : bxcan::kExtended);
}

}  // namespace hal::stm32f405
