#include "hal/stm32f405/step_timer.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

constexpr Address kCount = timer::kTim2 + timer::kCounter;
constexpr Address kDue = timer::kTim2 + timer::compare(1);
constexpr Address kBoundary = timer::kTim2 + timer::compare(2);
constexpr std::uint32_t kTurn = StepTimer<ModelBus>::kTurnTicks;

class StepTimerTest : public testing::Test {
 protected:
  StepTimerTest() { timer_.set_up(kFullSpeed); }

  /// Starts playing at a boundary, which is a multiple of a cycle.
  void start_at(std::uint32_t boundary) {
    chip_.cells[kCount] = boundary - 2 * kTurn;
    timer_.begin_turns();
    pass_boundary(boundary, [this] { timer_.start(); });
    EXPECT_EQ(std::vector<unsigned>{interrupt::kTim2}, chip_.pended) << "it is due at once";
    chip_.pended.clear();
  }

  template <typename Turn>
  void pass_boundary(std::uint32_t boundary, const Turn& turn) {
    ASSERT_EQ(boundary, chip_.cells[kBoundary]);
    chip_.cells[kCount] = boundary;
    timer_.on_interrupt([] { return 0U; }, turn);
  }

  /// Runs the interrupt at a count of the timer, with a program that requests `wait`; returns the
  /// next due count.
  std::uint32_t interrupt_at(std::uint32_t count, std::uint32_t wait) {
    chip_.cells[kCount] = count;
    chip_.pended.clear();
    timer_.on_interrupt(
        [&] {
          ++played_;
          due_ = timer_.due().raw();
          return wait;
        },
        [&] {
          ++turns_;
          order_.push_back(played_);
        });
    return chip_.cells[kDue];
  }

  ChipModel& chip_ = ModelBus::start_anew();
  StepTimer<ModelBus> timer_;
  int played_ = 0;
  int turns_ = 0;
  std::uint32_t due_ = 0;   ///< Due count of the last played event.
  std::vector<int> order_;  ///< Number of played events before each boundary.
};

TEST_F(StepTimerTest, CountsFourMillionTicksASecond) {
  EXPECT_EQ(84U / 4 - 1, chip_.cells[timer::kTim2 + timer::kPrescaler]);
  timer_.set_up(Clocks{});
  EXPECT_EQ(16U / 4 - 1, chip_.cells[timer::kTim2 + timer::kPrescaler]);
}

TEST_F(StepTimerTest, AsksForABoundaryThatWasMissed) {
  timer_.make_up();
  EXPECT_TRUE(chip_.pended.empty()) << "there are no boundaries yet";
  chip_.cells[kCount] = 8'000;
  timer_.begin_turns();
  const std::uint32_t boundary = chip_.cells[kBoundary];
  chip_.cells[kCount] = boundary + 399;
  timer_.make_up();
  EXPECT_TRUE(chip_.pended.empty()) << "it may be on its way";
  chip_.cells[kCount] = boundary + 400;
  timer_.make_up();
  EXPECT_EQ(std::vector<unsigned>{interrupt::kTim2}, chip_.pended);
  interrupt_at(boundary + 410, 0);
  EXPECT_EQ(1, turns_);
}

TEST_F(StepTimerTest, StartsAtABoundaryAndKeepsTimeWhateverTheDelay) {
  start_at(12'000);
  // The event is three ticks late, and `due` reports the time without the delay.
  EXPECT_EQ(12'100U, interrupt_at(12'003, 100));
  EXPECT_EQ(12'000U, due_);
  EXPECT_EQ(12'200U, interrupt_at(12'107, 100));
  EXPECT_EQ(12'250U, interrupt_at(12'200, 50));
  EXPECT_EQ(3, played_);
  EXPECT_TRUE(chip_.pended.empty());
}

TEST_F(StepTimerTest, ATimeThatHasPassedIsAskedForAtOnce) {
  start_at(12'000);
  interrupt_at(12'000, 100);
  EXPECT_EQ(12'120U, interrupt_at(12'125, 20));
  EXPECT_EQ(std::vector<unsigned>{interrupt::kTim2}, chip_.pended);
}

TEST_F(StepTimerTest, APulseLastsHoweverLongTheWayToItsEdgeWas) {
  constexpr std::uint32_t kPulse = 20;
  start_at(12'000);
  const auto edge_at = [&](std::uint32_t count, std::uint32_t wait) {
    timer_.on_interrupt(
        [&] {
          chip_.cells[kCount] = count;
          timer_.note_edge();
          return wait;
        },
        [] {});
    return chip_.cells[kDue];
  };
  EXPECT_EQ(12'013U + kPulse + 1, edge_at(12'013, kPulse));
  EXPECT_TRUE(chip_.pended.empty());
  chip_.cells[kCount] = 12'020;
  EXPECT_EQ(12'034U, interrupt_at(12'025, 5)) << "due, but the pulse is not over";
  EXPECT_EQ(0, played_);
  // The low level after the pulse has its minimum time, too. Afterwards, events come at their
  // requested times.
  chip_.cells[kCount] = 12'034;
  EXPECT_EQ(12'035U + kPulse + 1, edge_at(12'035, kPulse));
  EXPECT_EQ(12'140U, interrupt_at(12'056, 100));
}

TEST_F(StepTimerTest, WaysToEdgesDoNotAddUpOverPulses) {
  constexpr std::uint32_t kPulse = 20;
  constexpr std::uint32_t kInterval = 100;
  constexpr std::uint32_t kWay = 4;
  start_at(12'000);
  std::uint32_t comes = 12'000;
  for (std::uint32_t step = 0; step < 30; ++step) {
    EXPECT_EQ(12'000U + step * kInterval, comes);
    for (const bool high : {true, false}) {
      chip_.cells[kCount] = comes;
      timer_.on_interrupt(
          [&] {
            chip_.cells[kCount] = comes + kWay;
            if (high) timer_.note_edge();
            if (!high) timer_.note_pulse_end();
            return high ? kPulse : kInterval - kPulse;
          },
          [] {});
      comes = chip_.cells[kDue];
    }
  }
}

TEST_F(StepTimerTest, AnInterruptBeforeItsTimePlaysNothing) {
  start_at(12'000);
  interrupt_at(12'000, 100);
  EXPECT_EQ(12'100U, interrupt_at(12'050, 5));
  EXPECT_EQ(1, played_);
}

TEST_F(StepTimerTest, GoesOnAcrossTheEndOfTheCounter) {
  constexpr std::uint32_t kLast = 0xFFFF'FFFF / kTurn * kTurn;
  start_at(kLast);
  EXPECT_EQ(44U, interrupt_at(kLast, 44 - kLast));
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
  start_at(52'000);
  EXPECT_EQ(92'000U, interrupt_at(52'000, 0));
  EXPECT_EQ(1, played_);
  EXPECT_EQ(92'000U, interrupt_at(56'000, 1)) << "a boundary";
  EXPECT_EQ(1, played_);
}

TEST_F(StepTimerTest, WhatIsDueBeforeABoundaryIsPlayedBeforeIt) {
  start_at(12'000);
  interrupt_at(12'000, kTurn - 1);
  // The times of both events have passed.
  interrupt_at(16'003, 1);
  EXPECT_EQ(2, played_);
  EXPECT_EQ(0, turns_);
  EXPECT_EQ(std::vector<unsigned>{interrupt::kTim2}, chip_.pended);
  interrupt_at(16'004, 1);
  EXPECT_EQ(1, turns_) << "due at the boundary is after it";
  EXPECT_EQ(2, played_);
  interrupt_at(16'005, 100);
  EXPECT_EQ(3, played_);
  EXPECT_EQ(16'000U, due_);
  EXPECT_EQ(std::vector<int>{2}, order_);
}

/// An output that changes at rest belongs to a boundary, whereas the sign of life comes between two
/// boundaries.
TEST_F(StepTimerTest, ASignOfLifeAtRestLeavesTheTickOfTheLastBoundary) {
  start_at(12'000);
  interrupt_at(12'000, 0);
  constexpr std::uint32_t kSignOfLife = 12'000 + StepTimer<ModelBus>::kRestTicks;
  for (std::uint32_t boundary = 16'000; boundary <= kSignOfLife; boundary += kTurn) {
    pass_boundary(boundary, [] {});
  }
  EXPECT_EQ(kSignOfLife + 3 + StepTimer<ModelBus>::kRestTicks, interrupt_at(kSignOfLife + 3, 0));
  EXPECT_EQ(kSignOfLife, timer_.due().raw());
  EXPECT_EQ(1, played_);
}

TEST_F(StepTimerTest, BoundariesThatAreLateAreAllPassed) {
  chip_.cells[kCount] = 100;
  timer_.begin_turns();
  EXPECT_EQ(2 * kTurn, chip_.cells[kBoundary]);
  for (int turn = 1; turn <= 5; ++turn) {
    interrupt_at(6 * kTurn + 7, 1);
    EXPECT_EQ(turn, turns_);
  }
  EXPECT_TRUE(chip_.pended.empty());
  EXPECT_EQ(7 * kTurn, chip_.cells[kBoundary]);
}

}  // namespace
}  // namespace hal::stm32f405
