#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/interface/spsc_ring.hpp"

namespace hal::stm32f405 {

/// Between a link's interrupt and the main loop. Apart from the link, which begins with other
/// values than zeros: those of an object the image has to hold.
struct ByteRings {
  /// What arrives in 88 ms at 115,200 baud: the longest that the main loop is away.
  static constexpr std::uint32_t kReceiveBytes = 1024;
  static constexpr std::uint32_t kSendBytes = 512;

  SpscRing<std::byte, kReceiveBytes> received{};
  SpscRing<std::byte, kSendBytes> to_send{};
};

/// The same for USB, which tells the host to wait.
struct UsbRings {
  static constexpr std::uint32_t kReceiveBytes = 512;  ///< In a turn, which is a frame of USB.
  static constexpr std::uint32_t kSendBytes = 512;

  SpscRing<std::byte, kReceiveBytes> received{};
  SpscRing<std::byte, kSendBytes> to_send{};
};

}  // namespace hal::stm32f405
