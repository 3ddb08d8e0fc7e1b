#pragma once

#include <cstdint>

#include "hal/stm32f405/bus.hpp"

namespace hal::stm32f405 {

/// Bytes below the stack that nobody may touch; a power of two.
inline constexpr std::uint32_t kGuardBytes = 256;

/// Makes each access to the guard below the stack a fault. Everything else
/// stays as it is without protection. Once, at start-up.
/// @param guard start of it, a multiple of kGuardBytes.
template <RegisterBus Bus>
void guard_stack(Address guard) noexcept {
  constexpr Word kBytes = 7 << 1;   // 2^(7 + 1)
  constexpr Word kNever = bit(28);  // No code either; no access is 0.
  constexpr Word kOn = 1;
  constexpr Word kRestAsWithout = 4;
  static_assert(kGuardBytes == 2U << (kBytes >> 1));
  Bus::write(core::kRegion, 0);
  Bus::write(core::kRegionBase, guard);
  Bus::write(core::kRegionSize, kNever | kBytes | kOn);
  Bus::write(core::kProtection, kRestAsWithout | kOn);
}

/// The supply below 2.9 V interrupts: the beam goes dark before the brown-out, and flash takes no
/// writes (Flash).
template <RegisterBus Bus>
void watch_supply() noexcept {
  modify<Bus>(pwr::kCr, 7 << 5, pwr::kSupervisor2900mV | pwr::kSupervisorOn);
  set<Bus>(exti::kRising, exti::kSupplyLine);
  set<Bus>(exti::kMask, exti::kSupplyLine);
  enable_interrupt<Bus>(interrupt::kSupply, 0);
}

}  // namespace hal::stm32f405
