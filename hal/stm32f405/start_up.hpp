#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/stm32f405/bus.hpp"
#include "hal/stm32f405/image.hpp"
#include "hal/stm32f405/protection.hpp"

namespace hal::stm32f405 {

/// What the core finds at the start of the image: the stack's top and where to
/// go for each exception and interrupt. Aligned as VTOR wants it.
struct alignas(512) VectorTable {
  static constexpr std::size_t kCoreEntries = 15;  ///< Reset is the first.

  std::uint32_t* stack;
  std::array<Routine, kCoreEntries + interrupt::kCount> entries;

  /// The entry of an interrupt, as the chip numbers them.
  constexpr Routine& interrupt_entry(unsigned number) { return entries[kCoreEntries + number]; }
};
static_assert(sizeof(Routine) != 4 || sizeof(VectorTable) == 512);

/// Stops what a boot loader may have left running: interrupts, their timer, DMA.
/// Pins keep what they do, so the beam stays dark.
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

/// Sets the core up for the program: FPU, faults of their own, its vectors, the stack's guard. What
/// follows already runs under them: the barriers make the writes take effect first (Arm, DDI 0403E,
/// A3.7.3 and B3.2.5).
/// @param guard see guard_stack
template <RegisterBus Bus>
void start_core(Address vectors, Address guard) noexcept {
  set<Bus>(core::kCoprocessors, core::kFpuOn);
  Bus::write(core::kVectors, vectors);
  set<Bus>(core::kFaultControl, core::kFaultsOn);
  guard_stack<Bus>(guard);
  Bus::barrier();
}

}  // namespace hal::stm32f405
