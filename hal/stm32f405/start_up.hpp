#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/stm32f405/bus.hpp"
#include "hal/stm32f405/image.hpp"
#include "hal/stm32f405/protection.hpp"

namespace hal::stm32f405 {

/// Vector table, at the start of the image: the initial stack pointer, then the handler of each
/// exception and interrupt. The table is aligned as VTOR requires.
struct alignas(512) VectorTable {
  /// Number of entries of the core; the first is reset.
  static constexpr std::size_t kCoreEntries = 15;

  std::uint32_t* stack;
  std::array<Routine, kCoreEntries + interrupt::kCount> entries;

  /// Returns the entry of an interrupt. `number` is the chip's number of the interrupt.
  constexpr Routine& interrupt_entry(unsigned number) { return entries[kCoreEntries + number]; }
};
static_assert(sizeof(Routine) != 4 || sizeof(VectorTable) == 512);

/// Stops everything that a boot loader may have left running: interrupts, the core's timer, DMA,
/// USB and other peripherals. Pins keep their state, so the beam stays off.
template <RegisterBus Bus>
void forget_boot_loader() noexcept {
  constexpr Word kDmaUsbEthernet = bit(21) | bit(22) | bit(25) | bit(29);
  Bus::write(core::kTickControl, 0);
  for (unsigned group = 0; group * 32 < interrupt::kCount; ++group) {
    Bus::write(core::interrupt_off(32 * group), 0xFFFF'FFFF);
    Bus::write(core::interrupt_forget(32 * group), 0xFFFF'FFFF);
  }
  for (const Address block : {rcc::kAhb2Reset, rcc::kApb1Reset, rcc::kApb2Reset}) {
    Bus::write(block, 0xFFFF'FFFF);
    Bus::write(block, 0);
  }
  Bus::write(rcc::kAhb1Reset, kDmaUsbEthernet);
  Bus::write(rcc::kAhb1Reset, 0);
}

/// Sets up the core for the program: FPU, separate fault handlers, the vector table and the stack
/// guard. The barrier makes these writes take effect before the following code runs (Arm, DDI
/// 0403E, A3.7.3 and B3.2.5).
/// @param guard address of the guard, see guard_stack
template <RegisterBus Bus>
void start_core(Address vectors, Address guard) noexcept {
  set<Bus>(core::kCoprocessors, core::kFpuOn);
  Bus::write(core::kVectors, vectors);
  set<Bus>(core::kFaultControl, core::kFaultsOn);
  guard_stack<Bus>(guard);
  Bus::barrier();
}

}  // namespace hal::stm32f405
