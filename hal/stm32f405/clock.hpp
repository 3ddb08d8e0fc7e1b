#pragma once

#include <cstdint>

#include "hal/stm32f405/bus.hpp"

namespace hal::stm32f405 {

enum class ClockSource : std::uint8_t {
  kCrystal,  ///< 168 MHz from the board's crystal.
  /// 168 MHz from the chip's oscillator, within 1 %, because the crystal did not start.
  kInternal,
  kSlow,  ///< 16 MHz without PLL, too slow for the step interrupt.
};

/// Clock frequencies of the chip's parts, in Hz.
struct Clocks {
  ClockSource source = ClockSource::kSlow;
  std::uint32_t core = 16'000'000;
  std::uint32_t apb1 = 16'000'000;
  std::uint32_t apb2 = 16'000'000;
  std::uint32_t apb1_timers = 16'000'000;
  std::uint32_t apb2_timers = 16'000'000;
};

inline constexpr Clocks kFullSpeed{.source = ClockSource::kCrystal,
                                   .core = 168'000'000,
                                   .apb1 = 42'000'000,
                                   .apb2 = 84'000'000,
                                   .apb1_timers = 84'000'000,
                                   .apb2_timers = 168'000'000};

/// Returns whether the PLL can make 168 MHz from a crystal of `hz`. The PLL's input is 1 MHz, made
/// from the crystal's frequency by a whole divisor. The crystal must have 4 to 26 MHz (RM0090,
/// 7.3.2).
constexpr bool is_usable_crystal(std::uint32_t hz) {
  return hz % 1'000'000 == 0 && hz >= 4'000'000 && hz <= 26'000'000;
}

/// Sets the clocks from their state after reset to 168 MHz. Every wait is bounded. If the crystal
/// does not start or the PLL does not lock, the chip continues with a clock that works. The result
/// names the clock in use. Called once, before interrupts are enabled. Takes at most some 100 ms.
/// @pre is_usable_crystal(crystal_hz)
template <RegisterBus Bus>
class ClockStart {
 public:
  [[nodiscard]] static Clocks run(std::uint32_t crystal_hz) noexcept {
    back_to_internal();
    set<Bus>(rcc::kApb1Enr, rcc::kPowerClock);
    set<Bus>(pwr::kCr, pwr::kHighestScale);
    set<Bus>(rcc::kCr, rcc::kHseOn);
    const bool crystal = wait_for<Bus>(rcc::kCr, rcc::kHseReady, rcc::kHseReady, kCrystalLooks);
    if (!crystal) clear<Bus>(rcc::kCr, rcc::kHseOn);
    if (!start_pll(crystal ? crystal_hz : kInternalHz, crystal)) return {};
    if (!slow_flash_down() || !switch_over()) return {};
    if (crystal) set<Bus>(rcc::kCr, rcc::kSecurityOn);
    Clocks clocks = kFullSpeed;
    if (!crystal) clocks.source = ClockSource::kInternal;
    return clocks;
  }

 private:
  static constexpr std::uint32_t kInternalHz = 16'000'000;
  // Greatest numbers of reads in a wait. One read takes at least 4 clocks of 16 MHz. A crystal
  // needs 2 ms to start, up to 20 ms if it is cold.
  static constexpr std::uint32_t kCrystalLooks = 200'000;
  static constexpr std::uint32_t kPllLooks = 10'000;  ///< The PLL locks within 0.3 ms.

  /// Returns to the internal oscillator, because a boot loader may have selected any clock, and the
  /// settings of a running PLL cannot be changed.
  static void back_to_internal() noexcept {
    set<Bus>(rcc::kCr, rcc::kHsiOn);
    static_cast<void>(wait_for<Bus>(rcc::kCr, rcc::kHsiReady, rcc::kHsiReady, kPllLooks));
    Bus::write(rcc::kCfgr, 0);
    static_cast<void>(wait_for<Bus>(rcc::kCfgr, rcc::kSwitchedMask, 0, kPllLooks));
    clear<Bus>(rcc::kCr, rcc::kPllOn | rcc::kHseOn | rcc::kSecurityOn);
    static_cast<void>(wait_for<Bus>(rcc::kCr, rcc::kPllReady, 0, kPllLooks));
  }

  static bool start_pll(std::uint32_t input_hz, bool crystal) noexcept {
    const Word divider = input_hz / 1'000'000;
    // Makes 336 MHz, which is divided by 2 for the core and by 7 for USB.
    const Word multiplier = 336;
    Bus::write(rcc::kPllCfgr,
               divider | multiplier << 6 | (crystal ? rcc::kPllFromHse : 0) | Word{7} << 24);
    set<Bus>(rcc::kCr, rcc::kPllOn);
    if (wait_for<Bus>(rcc::kCr, rcc::kPllReady, rcc::kPllReady, kPllLooks)) return true;
    clear<Bus>(rcc::kCr, rcc::kPllOn);
    return false;
  }

  /// Sets the wait states of the flash before the core clock becomes faster than the flash. RM0090,
  /// 3.5.1 requires that the setting be read back.
  static bool slow_flash_down() noexcept {
    const Word wanted =
        flash::kFiveWaitStates | flash::kPrefetch | flash::kInstructionCache | flash::kDataCache;
    Bus::write(flash::kAcr, wanted);
    return wait_for<Bus>(flash::kAcr, wanted, wanted, kPllLooks);
  }

  static bool switch_over() noexcept {
    Bus::write(rcc::kCfgr, rcc::kApb1By4 | rcc::kApb2By2);
    set<Bus>(rcc::kCfgr, rcc::kSwitchToPll);
    if (wait_for<Bus>(rcc::kCfgr, rcc::kSwitchedMask, rcc::kSwitchedToPll, kPllLooks)) return true;
    Bus::write(rcc::kCfgr, 0);
    return false;
  }
};

}  // namespace hal::stm32f405
