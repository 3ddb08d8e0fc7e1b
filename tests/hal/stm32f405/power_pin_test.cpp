#include "hal/stm32f405/power_pin.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hal/stm32f405/boards/btt_skr_2.hpp"
#include "hal/stm32f405/boards/generic.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

template <const Board& kBoard>
void check_duties(Address base, unsigned channel, std::uint32_t clock) {
  ChipModel& chip = ModelBus::start_anew();
  PowerPin<kBoard, ModelBus> power;
  power.set_up(kFullSpeed);
  const std::uint32_t period = chip.cells[base + timer::kReload] + 1;
  const std::uint32_t divider = chip.cells[base + timer::kPrescaler] + 1;
  EXPECT_NEAR(kBoard.power_hz, static_cast<double>(clock) / divider / period, 1.0);
  std::uint32_t last = 0;
  for (std::uint32_t duty = 0; duty <= 65535; duty += 257) {
    power.set_duty(static_cast<std::uint16_t>(duty));
    const std::uint32_t high = chip.cells[base + timer::compare(channel)];
    EXPECT_NEAR(duty / 65535.0, static_cast<double>(high) / period, 0.6 / period);
    EXPECT_GE(high, last);
    last = high;
  }
  EXPECT_EQ(period, last) << "full is high without a gap";
  const std::size_t updates = chip.writes_to(base + timer::kEvents);
  power.set_duty(0);
  EXPECT_EQ(0U, chip.cells[base + timer::compare(channel)]);
  EXPECT_EQ(updates + 1, chip.writes_to(base + timer::kEvents)) << "dark at once";
}

TEST(PowerPin, DutyIsTheShareOfThePeriod) {
  check_duties<kGeneric>(timer::kTim1, 1, 168'000'000);
  check_duties<kBttSkr2>(timer::kTim3, 3, 84'000'000);
}

TEST(PowerPin, ThePinIsTheTimersOnlyWhenTheTimerIsDark) {
  ChipModel& chip = ModelBus::start_anew();
  PowerPin<kGeneric, ModelBus> power;
  power.set_up(kFullSpeed);
  EXPECT_EQ(2U, chip.mode_of(kGeneric.power));
  EXPECT_EQ(gpio::mode(kGeneric.power.port), chip.writes.back().first);
  EXPECT_EQ(timer::kMainOutput, chip.cells[timer::kTim1 + timer::kBreak]);
}

TEST(PowerPin, DarkeningIsALowThatIsDrivenWhateverWasBefore) {
  ChipModel& chip = ModelBus::start_anew();
  PowerPin<kGeneric, ModelBus> power;
  power.set_up(kFullSpeed);
  power.set_duty(65535);
  chip.pins_driven_high[kGeneric.power.port] = 0xFFFF;
  chip.writes.clear();
  PowerPin<kGeneric, ModelBus>::darken();
  EXPECT_FALSE(chip.is_high(kGeneric.power));
  EXPECT_EQ(1U, chip.mode_of(kGeneric.power));
  EXPECT_FALSE(chip.is_high(kGeneric.spindle_enable));
  ASSERT_GE(chip.writes.size(), 3U);
  EXPECT_EQ(rcc::kAhb1Enr, chip.writes[0].first);
  EXPECT_EQ(gpio::set_reset(0), chip.writes[1].first) << "low before it drives";
  EXPECT_EQ(gpio::mode(0), chip.writes[2].first);
}

}  // namespace
}  // namespace hal::stm32f405
