#pragma once

/// Functions that end a program on an STM32F405, and the record of the end for the next start.

#include <bit>
#include <cstdint>

#include "hal/stm32f405/reset_cause.hpp"

namespace target {

/// Memory that keeps its content over a restart.
struct Kept {
  static constexpr std::uint32_t kBootLoader = 0x4446'5521;
  /// Value of `wanted`: the start-up has not found the image fit to run yet. If it is still set at
  /// the next start, the check of the image failed or did not end.
  static constexpr std::uint32_t kUnfit = 0x4E4F'5421;

  std::uint32_t wanted;
  hal::stm32f405::FaultRecord fault;
};
extern Kept kept;

[[noreturn]] void restart();

/// Ends the program; may be called in every state of the program. First switches the beam off. The
/// restart then switches off the current of the motors and reports the fault.
[[noreturn]] void stop(hal::stm32f405::Fault fault, std::uint32_t exception, std::uint32_t place);

/// Jumps to ST's boot loader. Requires the chip in its state after a reset.
[[noreturn]] void enter_boot_loader();

/// Waits for the next reset, which starts the program again. The beam is off, and no other part of
/// the chip was started.
[[noreturn]] void stand_still();

inline std::uint32_t address_of(const void* object) { return std::bit_cast<std::uint32_t>(object); }

}  // namespace target

extern "C" [[gnu::naked, noreturn]] void fault_entry();
extern "C" void supply_interrupt();
