#pragma once

#include <cstdint>

#include "hal/stm32f405/bus.hpp"

namespace hal::stm32f405 {

/// Size in bytes of the guard below the stack, a power of two. No code may access the guard.
inline constexpr std::uint32_t kGuardBytes = 256;

/// Makes each access to the guard below the stack a fault. All other memory remains accessible, as
/// without protection. Called once, at start-up.
/// @param guard start of the guard, a multiple of kGuardBytes
template <RegisterBus Bus>
void guard_stack(Address guard) noexcept {
  constexpr Word kBytes = 7 << 1;   // Size field 7: a region of 2^(7 + 1) bytes.
  constexpr Word kNever = bit(28);  // Forbids execution; access code 0 forbids reads and writes.
  constexpr Word kOn = 1;
  constexpr Word kRestAsWithout = 4;
  static_assert(kGuardBytes == 2U << (kBytes >> 1));
  Bus::write(core::kRegion, 0);
  Bus::write(core::kRegionBase, guard);
  Bus::write(core::kRegionSize, kNever | kBytes | kOn);
  Bus::write(core::kProtection, kRestAsWithout | kOn);
}

/// Makes a supply voltage below 2.9 V raise an interrupt, so that the beam goes off before the
/// brown-out reset. The flash then also refuses writes (Flash).
template <RegisterBus Bus>
void watch_supply() noexcept {
  modify<Bus>(pwr::kCr, 7 << 5, pwr::kSupervisor2900mV | pwr::kSupervisorOn);
  set<Bus>(exti::kRising, exti::kSupplyLine);
  set<Bus>(exti::kMask, exti::kSupplyLine);
  enable_interrupt<Bus>(interrupt::kSupply, 0);
}

}  // namespace hal::stm32f405
