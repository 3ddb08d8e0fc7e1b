#include "hal/stm32f405/clock.hpp"

#include <gtest/gtest.h>

#include "hal/stm32f405/time_base.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

using Start = ClockStart<ModelBus>;

/// Returns the frequency that the PLL makes of its input, Hz; 0 if its input or its oscillator is
/// outside of RM0090's limits.
std::uint64_t pll_output(Word settings, std::uint64_t input) {
  const std::uint64_t reference = input / (settings & 0x3FU);
  const std::uint64_t oscillator = reference * (settings >> 6 & 0x1FFU);
  if (reference < 1'000'000 || reference > 2'000'000) return 0;
  if (oscillator < 100'000'000 || oscillator > 432'000'000) return 0;
  return oscillator / (2 * (settings >> 16 & 3U) + 2);
}

TEST(Clock, Makes168MHzOfEachCrystal) {
  for (const std::uint32_t crystal : {8'000'000U, 12'000'000U, 25'000'000U}) {
    ChipModel& chip = ModelBus::start_anew();
    const Clocks clocks = Start::run(crystal);
    EXPECT_EQ(ClockSource::kCrystal, clocks.source);
    EXPECT_EQ(168'000'000U, pll_output(chip.cells[rcc::kPllCfgr], crystal));
    EXPECT_NE(0U, chip.cells[rcc::kPllCfgr] & rcc::kPllFromHse);
    EXPECT_EQ(rcc::kSwitchedToPll, chip.cells[rcc::kCfgr] & rcc::kSwitchedMask);
    EXPECT_EQ(5U, chip.cells[flash::kAcr] & 0xFU);
    EXPECT_NE(0U, chip.cells[rcc::kCr] & rcc::kSecurityOn);
    EXPECT_EQ(84'000'000U, clocks.apb1_timers);
  }
}

TEST(Clock, WithoutACrystalTakesTheChipsOwn) {
  ChipModel& chip = ModelBus::start_anew();
  chip.crystal_starts = false;
  const Clocks clocks = Start::run(8'000'000);
  EXPECT_EQ(ClockSource::kInternal, clocks.source);
  EXPECT_EQ(168'000'000U, pll_output(chip.cells[rcc::kPllCfgr], 16'000'000));
  EXPECT_EQ(0U, chip.cells[rcc::kPllCfgr] & rcc::kPllFromHse);
  EXPECT_EQ(0U, chip.cells[rcc::kCr] & (rcc::kHseOn | rcc::kSecurityOn));
  EXPECT_LT(chip.reads, 300'000U) << "waits must be bounded";
}

TEST(Clock, WithoutAPllStaysSlow) {
  ChipModel& chip = ModelBus::start_anew();
  chip.pll_locks = false;
  const Clocks clocks = Start::run(8'000'000);
  EXPECT_EQ(ClockSource::kSlow, clocks.source);
  EXPECT_EQ(16'000'000U, clocks.core);
  EXPECT_EQ(0U, chip.cells[rcc::kCfgr] & rcc::kSwitchMask);
  EXPECT_EQ(0U, chip.cells[rcc::kCr] & rcc::kPllOn);
  EXPECT_LT(chip.reads, 300'000U);
}

TEST(Clock, TheFlashIsSlowedDownBeforeTheCoreIsFast) {
  ChipModel& chip = ModelBus::start_anew();
  static_cast<void>(Start::run(8'000'000));
  std::size_t slowed = 0;
  std::size_t switched = 0;
  for (std::size_t i = 0; i < chip.writes.size(); ++i) {
    const auto& [address, value] = chip.writes[i];
    if (address == flash::kAcr) slowed = i;
    if (address == rcc::kCfgr && (value & rcc::kSwitchMask) == rcc::kSwitchToPll) switched = i;
  }
  EXPECT_GT(slowed, 0U);
  EXPECT_GT(switched, slowed);
}

TEST(Clock, ABootLoadersPllIsStoppedBeforeItIsChanged) {
  ChipModel& chip = ModelBus::start_anew();
  chip.write(rcc::kCr, rcc::kHsiOn | rcc::kHseOn | rcc::kPllOn);
  chip.write(rcc::kCfgr, rcc::kSwitchToPll);
  chip.writes.clear();
  static_cast<void>(Start::run(8'000'000));
  bool running = true;
  for (const auto& [address, value] : chip.writes) {
    if (address == rcc::kCr) running = (value & rcc::kPllOn) != 0;
    if (address == rcc::kPllCfgr) {
      EXPECT_FALSE(running);
    }
  }
}

TEST(TimeBase, CountsMicrosecondsWithinAndAcrossPeriods) {
  ChipModel& chip = ModelBus::start_anew();
  TimeBase<ModelBus> time;
  time.set_up(kFullSpeed);
  EXPECT_EQ(250 * 168U - 1, chip.cells[core::kTickReload]);
  chip.cells[core::kTickValue] = 250 * 168 - 1;
  EXPECT_EQ(0U, time.now().raw());
  chip.cells[core::kTickValue] = 168 * 50;
  EXPECT_EQ(199U, time.now().raw());
  time.on_interrupt();
  EXPECT_EQ(449U, time.now().raw());
}

}  // namespace
}  // namespace hal::stm32f405
