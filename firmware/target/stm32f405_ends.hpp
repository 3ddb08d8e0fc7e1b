#pragma once

/// The ways in which a program ends on an STM32F405, and the record of the end for the next start.

#include <bit>
#include <cstdint>

#include "hal/stm32f405/reset_cause.hpp"

namespace target {

/// Memory that keeps its content over a restart.
struct Kept {
  static constexpr std::uint32_t kBootLoader = 0x4446'5521;
  /// The last start found the image unfit to run.
  static constexpr std::uint32_t kUnfit = 0x4E4F'5421;

  std::uint32_t wanted;
  hal::stm32f405::FaultRecord fault;
};
extern Kept kept;

[[noreturn]] void restart();

/// Ends the program: first switches the beam off, whatever the program was doing. The restart
/// switches off the motors' current and reports the fault.
[[noreturn]] void stop(hal::stm32f405::Fault fault, std::uint32_t exception, std::uint32_t place);

/// Jumps from flash to ST's boot loader, which requires the chip in its state after reset.
[[noreturn]] void enter_boot_loader();

/// Waits for the next reset, which tries again. The beam is off, and nothing else was started.
[[noreturn]] void stand_still();

inline std::uint32_t address_of(const void* object) { return std::bit_cast<std::uint32_t>(object); }

}  // namespace target

extern "C" [[gnu::naked, noreturn]] void fault_entry();
extern "C" void supply_interrupt();
