#pragma once

#include <cstdint>

#include "hal/stm32f405/board.hpp"

namespace hal::stm32f405 {

/// The pin of the beam power or of the spindle speed. A separate timer makes the duty cycle. At
/// duty 0 the pin stays low; at full duty it stays high.
template <const Board& kBoard, RegisterBus Bus>
class PowerPin {
 public:
  /// Makes the power pin and the spindle's enable pin plain outputs at low level. This is the first
  /// action after reset and after any fault. It needs no memory, no peripheral clocks and no
  /// earlier set-up.
  [[gnu::always_inline]] static void darken() noexcept {
    darken(kBoard.power);
    if constexpr (kBoard.spindle_enable.exists()) darken(kBoard.spindle_enable);
  }

  /// Sets up the timer with duty 0. Called once, with interrupts off.
  void set_up(const Clocks& clocks) noexcept {
    set<Bus>(kChannel.clock(), kChannel.clock_bit());
    period_ = (kChannel.fast() ? clocks.apb2_timers : clocks.apb1_timers) / kBoard.power_hz;
    std::uint32_t divider = 1;
    while (period_ / divider > kLongestPeriod) ++divider;
    period_ /= divider;
    const Address base = kChannel.timer;
    Bus::write(base + timer::kPrescaler, divider - 1);
    Bus::write(base + timer::kReload, period_ - 1);
    Bus::write(base + compare(), 0);
    modify<Bus>(base + timer::compare_mode(kChannel.channel),
                Word{0xFF} << (8 * ((kChannel.channel - 1) % 2)),
                timer::pwm_mode(kChannel.channel));
    set<Bus>(base + timer::kCompareEnable, timer::output_on(kChannel.channel));
    if constexpr (kChannel.fast()) Bus::write(base + timer::kBreak, timer::kMainOutput);
    Bus::write(base + timer::kEvents, timer::kUpdate);
    Bus::write(base + timer::kCr1, timer::kCounterOn | timer::kReloadPreload);
    PinSetUp<Bus>::hand_over(kBoard.power, kChannel.function, false);
  }

  /// Sets the duty. It takes effect with the next period; duty 0 takes effect immediately. Any
  /// context.
  /// @param duty 0 to 65535, which is full duty
  void set_duty(std::uint16_t duty) noexcept {
    // Duty 65535 becomes the full period, a value that the counter never reaches, so the output has
    // no gap.
    const std::uint32_t high = (duty * period_ + kFull / 2) / kFull;
    Bus::write(kChannel.timer + compare(), high);
    if (duty == 0) Bus::write(kChannel.timer + timer::kEvents, timer::kUpdate);
  }

  /// Returns whether the duty in the timer's register is above 0. Any context, after set_up().
  [[nodiscard]] static bool lit() noexcept { return Bus::read(kChannel.timer + compare()) != 0; }

  /// Returns whether the pulses in the timer's registers are longer than those of `duty`. Any
  /// context.
  [[nodiscard]] static bool exceeds(std::uint16_t duty) noexcept {
    const std::uint32_t period = Bus::read(kChannel.timer + timer::kReload) + 1;
    return Bus::read(kChannel.timer + compare()) > (duty * period + kFull / 2) / kFull;
  }

 private:
  static constexpr PowerChannel kChannel = CheckedBoard<kBoard>::kPower;
  static constexpr std::uint32_t kFull = 65535;
  /// Upper bound of the period in clocks. It lets period and duty fit into 16 bits, and their
  /// product into 32 bits.
  static constexpr std::uint32_t kLongestPeriod = 65535;

  static constexpr Address compare() { return timer::compare(kChannel.channel); }

  [[gnu::always_inline]] static void darken(Pin pin) noexcept {
    set<Bus>(rcc::kAhb1Enr, bit(pin.port));
    static_cast<void>(Bus::read(rcc::kAhb1Enr));
    Bus::write(gpio::set_reset(pin.port), pin.mask() << 16);
    modify<Bus>(gpio::mode(pin.port), Word{3} << (2U * pin.number), Word{1} << (2U * pin.number));
  }

  std::uint32_t period_ = 0;
};

}  // namespace hal::stm32f405
