#pragma once

#include <cstdint>

namespace hal::stm32f405::usb {

/// Vendor and product numbers that a device reports.
///
/// The default numbers are the test numbers of pid.codes. They may be used for private tests of a
/// board, but not for boards that are given away or sold. The supplier of a board must put its own
/// numbers into the board's header; an open-source board can get a number from pid.codes. ST's
/// number 0483:5740 must not be used, because it belongs to ST, although many products use it.
struct Identity {
  std::uint16_t vendor = 0x1209;
  std::uint16_t product = 0x0001;
};

}  // namespace hal::stm32f405::usb
