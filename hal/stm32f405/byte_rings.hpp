#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/interface/spsc_ring.hpp"

namespace hal::stm32f405 {

/// Queues between a link's interrupt and the main loop. They are separate from the link object
/// because that object has initial values other than zero, all of which the image must store.
struct ByteRings {
  /// Bytes that arrive in 88 ms at 115,200 baud, the longest time between two reads by the main
  /// loop.
  static constexpr std::uint32_t kReceiveBytes = 1024;
  static constexpr std::uint32_t kSendBytes = 512;

  SpscRing<std::byte, kReceiveBytes> received{};
  SpscRing<std::byte, kSendBytes> to_send{};
};

/// Queues like ByteRings, for USB, which makes the host wait when they are full.
struct UsbRings {
  static constexpr std::uint32_t kReceiveBytes = 512;  ///< Bytes of one cycle, which is one USB
                                                       ///< frame.
  static constexpr std::uint32_t kSendBytes = 512;

  SpscRing<std::byte, kReceiveBytes> received{};
  SpscRing<std::byte, kSendBytes> to_send{};
};

}  // namespace hal::stm32f405
