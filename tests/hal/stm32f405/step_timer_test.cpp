#include "hal/stm32f405/step_timer.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

constexpr Address kCount = timer::kTim2 + timer::kCounter;
constexpr Address kDue = timer::kTim2 + timer::compare(1);

class StepTimerTest : public testing::Test {
 protected:
  StepTimerTest() { timer_.set_up(kFullSpeed); }

  /// The interrupt at this count of the timer; the program wants `wait`.
  std::uint32_t interrupt_at(std::uint32_t count, std::uint32_t wait) {
    chip_.cells[kCount] = count;
    chip_.pended.clear();
    timer_.on_interrupt([&] {
      ++played_;
      return wait;
    });
    return chip_.cells[kDue];
  }

  ChipModel& chip_ = ModelBus::start_anew();
  StepTimer<ModelBus> timer_;
  int played_ = 0;
};

TEST_F(StepTimerTest, CountsFourMillionTicksASecond) {
  EXPECT_EQ(84U / 4 - 1, chip_.cells[timer::kTim2 + timer::kPrescaler]);
  timer_.set_up(Clocks{});
  EXPECT_EQ(16U / 4 - 1, chip_.cells[timer::kTim2 + timer::kPrescaler]);
}

TEST_F(StepTimerTest, StartsAtOnceAndKeepsTimeWhateverTheDelay) {
  timer_.start();
  EXPECT_EQ(std::vector<unsigned>{interrupt::kTim2}, chip_.pended);
  EXPECT_EQ(1100U, interrupt_at(1000, 100));
  // Seven ticks late, and still due a hundred after it should have been.
  EXPECT_EQ(1200U, interrupt_at(1107, 100));
  EXPECT_EQ(1250U, interrupt_at(1200, 50));
  EXPECT_EQ(3, played_);
  EXPECT_TRUE(chip_.pended.empty());
}

TEST_F(StepTimerTest, ATimeThatHasPassedIsAskedForAtOnce) {
  timer_.start();
  interrupt_at(1000, 100);
  EXPECT_EQ(1120U, interrupt_at(1125, 20));
  EXPECT_EQ(std::vector<unsigned>{interrupt::kTim2}, chip_.pended);
}

TEST_F(StepTimerTest, APulseLastsHoweverLongTheWayToItsEdgeWas) {
  constexpr std::uint32_t kPulse = 20;
  timer_.start();
  const auto edge_at = [&](std::uint32_t count, std::uint32_t wait) {
    timer_.on_interrupt([&] {
      chip_.cells[kCount] = count;
      timer_.note_edge();
      return wait;
    });
    return chip_.cells[kDue];
  };
  chip_.cells[kCount] = 1000;
  EXPECT_EQ(1013U + kPulse + 1, edge_at(1013, kPulse));
  EXPECT_TRUE(chip_.pended.size() == 1) << "only the start";
  chip_.cells[kCount] = 1020;
  EXPECT_EQ(1034U, interrupt_at(1025, 5)) << "due, but the pulse is not over";
  EXPECT_EQ(0, played_);
  // The low after it lasts, too; then the times are those that were asked for.
  chip_.cells[kCount] = 1034;
  EXPECT_EQ(1035U + kPulse + 1, edge_at(1035, kPulse));
  EXPECT_EQ(1140U, interrupt_at(1056, 100));
}

TEST_F(StepTimerTest, WaysToEdgesDoNotAddUpOverPulses) {
  constexpr std::uint32_t kPulse = 20;
  constexpr std::uint32_t kInterval = 100;
  constexpr std::uint32_t kWay = 4;
  timer_.start();
  std::uint32_t comes = 1000;
  for (std::uint32_t step = 0; step < 50; ++step) {
    EXPECT_EQ(1000U + step * kInterval, comes);
    for (const bool high : {true, false}) {
      chip_.cells[kCount] = comes;
      timer_.on_interrupt([&] {
        chip_.cells[kCount] = comes + kWay;
        if (high) timer_.note_edge();
        if (!high) timer_.note_pulse_end();
        return high ? kPulse : kInterval - kPulse;
      });
      comes = chip_.cells[kDue];
    }
  }
}

TEST_F(StepTimerTest, AnInterruptBeforeItsTimePlaysNothing) {
  timer_.start();
  interrupt_at(1000, 100);
  EXPECT_EQ(1100U, interrupt_at(1050, 5));
  EXPECT_EQ(1, played_);
}

TEST_F(StepTimerTest, GoesOnAcrossTheEndOfTheCounter) {
  timer_.start();
  EXPECT_EQ(44U, interrupt_at(0xFFFF'FFD0, 92));
  interrupt_at(20, 92);
  EXPECT_EQ(1, played_) << "not due yet";
  interrupt_at(44, 92);
  EXPECT_EQ(2, played_);
}

TEST_F(StepTimerTest, AtRestShowsThatItIsAliveAndPlaysNothing) {
  EXPECT_FALSE(timer_.take_alive());
  EXPECT_EQ(80'000U, interrupt_at(40'000, 1));
  EXPECT_EQ(0, played_);
  EXPECT_TRUE(timer_.take_alive());
  EXPECT_FALSE(timer_.take_alive());
  timer_.start();
  interrupt_at(50'000, 0);
  EXPECT_EQ(1, played_);
  EXPECT_EQ(130'000U, interrupt_at(90'000, 1)) << "rests again after a 0";
  EXPECT_EQ(1, played_);
}

}  // namespace
}  // namespace hal::stm32f405
