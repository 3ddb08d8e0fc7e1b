#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/interface/spsc_ring.hpp"

namespace hal::stm32f405 {

/// Queues between a link's interrupt and the main loop. They are separate from the link object,
/// because that object has non-zero initial values, and the image must then store all bytes of the
/// object.
struct ByteRings {
  /// Capacity for the bytes that arrive at 115,200 baud in 88 ms, the longest time between two
  /// reads by the main loop.
  static constexpr std::uint32_t kReceiveBytes = 1024;
  static constexpr std::uint32_t kSendBytes = 512;

  SpscRing<std::byte, kReceiveBytes> received{};
  SpscRing<std::byte, kSendBytes> to_send{};
};

/// Queues for USB, like ByteRings. USB makes the host wait while they are full.
struct UsbRings {
  /// Capacity for the bytes of one cycle, which has the length of a USB frame.
  static constexpr std::uint32_t kReceiveBytes = 512;
  static constexpr std::uint32_t kSendBytes = 512;

  SpscRing<std::byte, kReceiveBytes> received{};
  SpscRing<std::byte, kSendBytes> to_send{};
};

}  // namespace hal::stm32f405
