#pragma once

#include <cstdint>

namespace hal::stm32f405::usb {

/// Whose product a device says it is.
///
/// The numbers that stand here are pid.codes' for tests: right for a board on
/// one's own desk, and not to be given away or sold. Who ships a board names its
/// own in the board's header; an open one gets a number from pid.codes. ST's
/// 0483:5740 belongs to ST, however many use it.
struct Identity {
  std::uint16_t vendor = 0x1209;
  std::uint16_t product = 0x0001;
};

}  // namespace hal::stm32f405::usb
