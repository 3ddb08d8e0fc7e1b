#pragma once

/// How a program ends on an STM32F405, and what the next start is to know of it.

#include <bit>
#include <cstdint>

#include "hal/stm32f405/reset_cause.hpp"

namespace target {

/// Memory that keeps its content over a restart.
struct Kept {
  static constexpr std::uint32_t kBootLoader = 0x4446'5521;
  /// The last start did not find the image fit to run.
  static constexpr std::uint32_t kUnfit = 0x4E4F'5421;

  std::uint32_t wanted;
  hal::stm32f405::FaultRecord fault;
};
extern Kept kept;

[[noreturn]] void restart();

/// Ends the program: whatever it was doing, the beam is switched off first. The restart takes the
/// current off the motors and reports the fault.
[[noreturn]] void stop(hal::stm32f405::Fault fault, std::uint32_t exception, std::uint32_t place);

/// Jumps from flash to ST's boot loader, which needs the chip as reset leaves it.
[[noreturn]] void enter_boot_loader();

/// Waits for the next reset, which tries again: the beam is off, and nothing else was begun.
[[noreturn]] void stand_still();

inline std::uint32_t address_of(const void* object) { return std::bit_cast<std::uint32_t>(object); }

}  // namespace target

extern "C" [[gnu::naked, noreturn]] void fault_entry();
extern "C" void supply_interrupt();
