// Tests the requirements of hal/interface on every port. A bench adapts each port: it holds the
// port, and observes and drives its pins.

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "hal/host/recording_port.hpp"
#include "hal/stm32f405/boards/btt_skr_2.hpp"
#include "hal/stm32f405/boards/btt_skr_pro_1_2.hpp"
#include "hal/stm32f405/boards/generic.hpp"
#include "hal/stm32f405/boards/mks_robin_nano_v3.hpp"
#include "hal/stm32f405/port.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal {
namespace {

/// Bench of the simulator's port.
struct HostBench {
  static constexpr std::uint8_t kMotors = 0b111111;
  static constexpr std::size_t kOutputs = 8;
  host::RecordingPort port{};

  std::int32_t position(std::size_t axis) { return port.position[axis]; }
  double duty() { return port.power / 65535.0; }
  bool output(std::size_t number) { return (port.digital >> number & 1U) != 0; }
  bool plays_after_start() {
    port.start_timer();
    return port.timer_started;
  }
  bool motors_have_current() { return port.motors_enabled != 0; }
  bool spindle_enabled() { return port.spindle_enabled; }
  void touch_probe(bool contact) { port.probe = contact; }
  void close_limit(std::size_t axis) { port.limits.first = static_cast<std::uint8_t>(1U << axis); }
  void press_hold(bool pressed) { port.panel.hold = pressed; }
  void after_steps() {}
};

/// Bench of a board with the chip, on a model of its registers.
template <const stm32f405::Board& kBoard>
struct ChipBench {
  using Bus = stm32f405::ModelBus;
  static constexpr std::uint8_t kMotors = [] {
    unsigned motors = 0;
    for (std::size_t axis = 0; axis < stm32f405::kAxes; ++axis) {
      if (kBoard.motors[axis].step.exists()) motors |= 1U << axis;
    }
    return static_cast<std::uint8_t>(motors);
  }();
  static constexpr std::size_t kOutputs = [] {
    std::size_t count = 0;
    while (count < kBoard.outputs.size() && kBoard.outputs[count].exists()) ++count;
    return count;
  }();

  stm32f405::ChipModel& chip = Bus::start_anew();
  stm32f405::Port<kBoard, Bus> port{};

  ChipBench() {
    port.set_up(stm32f405::kFullSpeed);
    chip.pended.clear();
  }

  std::int32_t position(std::size_t axis) { return counted[axis]; }
  /// Returns the share of the timer's period during which the pin is high.
  double duty() {
    constexpr stm32f405::PowerChannel kChannel = stm32f405::power_channel_of(kBoard.power);
    if (chip.mode_of(kBoard.power) != 2) return chip.is_high(kBoard.power) ? 1.0 : 0.0;
    const double high = chip.cells[kChannel.timer + stm32f405::timer::compare(kChannel.channel)];
    return high / (chip.cells[kChannel.timer + stm32f405::timer::kReload] + 1.0);
  }
  bool output(std::size_t number) { return chip.is_high(kBoard.outputs[number]); }
  /// Starts the timer at a boundary, as the product does; returns whether it plays.
  bool plays_after_start() {
    using Timer = stm32f405::StepTimer<Bus>;
    bool played = false;
    const auto play = [&] {
      played = true;
      return 0U;
    };
    port.timer().begin_turns();
    chip.cells[stm32f405::timer::kTim2 + stm32f405::timer::kCounter] = 2 * Timer::kTurnTicks;
    port.timer().on_interrupt(play, [] {});
    EXPECT_FALSE(played);
    chip.cells[stm32f405::timer::kTim2 + stm32f405::timer::kCounter] = 3 * Timer::kTurnTicks;
    port.timer().on_interrupt(play, [&] { port.start_timer(); });
    port.timer().on_interrupt(play, [] {});
    return played;
  }
  bool motors_have_current() {
    const stm32f405::Pin common = kBoard.motors_enable;
    return !chip.is_high(common.exists() ? common : kBoard.motors[0].enable);
  }
  bool spindle_enabled() { return chip.is_high(kBoard.spindle_enable); }
  void touch_probe(bool contact) { chip.feed(kBoard.probe, !contact); }
  void close_limit(std::size_t axis) { chip.feed(kBoard.limits[axis], false); }
  void press_hold(bool pressed) { chip.feed(kBoard.hold, !pressed); }

  /// Counts leading edges as a motor driver does.
  void after_steps() {
    for (std::size_t axis = 0; axis < stm32f405::kAxes; ++axis) {
      const stm32f405::Motor& motor = kBoard.motors[axis];
      if (!motor.step.exists()) continue;
      const bool high = chip.is_high(motor.step);
      if (high && !was_high[axis]) counted[axis] += chip.is_high(motor.direction) ? -1 : 1;
      was_high[axis] = high;
    }
  }
  std::array<std::int32_t, stm32f405::kAxes> counted{};
  std::array<bool, stm32f405::kAxes> was_high{};
};

template <typename Bench>
class PortContract : public testing::Test {
 protected:
  void step(std::uint8_t axes) {
    bench_.port.raise_steps({axes}, {});
    bench_.after_steps();
    bench_.port.lower_steps();
    bench_.after_steps();
  }
  Bench bench_{};
};

using Benches = testing::Types<HostBench,
                               ChipBench<stm32f405::kGeneric>,
                               ChipBench<stm32f405::kBttSkr2>,
                               ChipBench<stm32f405::kBttSkrPro12>,
                               ChipBench<stm32f405::kMksRobinNanoV30>>;
TYPED_TEST_SUITE(PortContract, Benches);

TYPED_TEST(PortContract, EachStepMovesItsMotorOnceInItsDirection) {
  std::array<std::int32_t, 6> expected{};
  for (unsigned turn = 0; turn < 200; ++turn) {
    const auto axes = static_cast<std::uint8_t>((turn * 37 + 11) & TypeParam::kMotors);
    const auto negative = static_cast<std::uint8_t>((turn * 23) & TypeParam::kMotors);
    this->bench_.port.set_direction({negative});
    this->step(axes);
    for (std::size_t axis = 0; axis < 6; ++axis) {
      if ((axes >> axis & 1U) != 0) expected[axis] += (negative >> axis & 1U) != 0 ? -1 : 1;
      EXPECT_EQ(expected[axis], this->bench_.position(axis));
    }
  }
}

TYPED_TEST(PortContract, ADirectionHoldsUntilTheNext) {
  this->bench_.port.set_direction({0b01});
  this->step(0b11);
  this->step(0b11);
  EXPECT_EQ(-2, this->bench_.position(0));
  EXPECT_EQ(2, this->bench_.position(1));
}

TYPED_TEST(PortContract, LoweringWhatIsLowDoesNothing) {
  this->bench_.port.lower_steps();
  this->bench_.after_steps();
  this->bench_.port.raise_steps({}, {});
  this->bench_.after_steps();
  EXPECT_EQ(0, this->bench_.position(0));
}

TYPED_TEST(PortContract, PowerIsADutyWhoseEndsAreExact) {
  EXPECT_EQ(0.0, this->bench_.duty());
  for (const std::uint16_t power : std::array<std::uint16_t, 4>{1, 300, 32768, 65000}) {
    this->bench_.port.set_power(power);
    EXPECT_NEAR(power / 65535.0, this->bench_.duty(), 5e-4);
  }
  this->bench_.port.set_power(65535);
  EXPECT_EQ(1.0, this->bench_.duty());
  this->bench_.port.set_power(0);
  EXPECT_EQ(0.0, this->bench_.duty());
}

TYPED_TEST(PortContract, OutputsChangeAloneFromEitherContext) {
  for (std::size_t number = 0; number < TypeParam::kOutputs; ++number) {
    const auto bit = static_cast<std::uint8_t>(1U << number);
    this->bench_.port.change_outputs(bit, 0);
    for (std::size_t other = 0; other < TypeParam::kOutputs; ++other) {
      EXPECT_EQ(other == number, this->bench_.output(other));
    }
    this->bench_.port.change_outputs(0, bit);
    EXPECT_FALSE(this->bench_.output(number));
    this->bench_.port.set_digital(static_cast<std::uint8_t>(number), true);
    EXPECT_TRUE(this->bench_.output(number));
    this->bench_.port.set_digital(static_cast<std::uint8_t>(number), false);
    EXPECT_FALSE(this->bench_.output(number));
  }
}

TYPED_TEST(PortContract, WhatTheBoardHasNotIsNoFault) {
  this->bench_.port.change_outputs(0xFF, 0);
  this->bench_.port.change_outputs(0, 0xFF);
  this->bench_.port.set_digital(7, true);
  this->bench_.port.set_analog(200, 65535);
  this->bench_.port.set_analog_output(200, 65535);
  EXPECT_EQ(0.0, this->bench_.duty());
  EXPECT_EQ(0, this->bench_.position(0));
}

TYPED_TEST(PortContract, TheTimerIsStartedByAskingForIt) {
  EXPECT_TRUE(this->bench_.plays_after_start());
}

TYPED_TEST(PortContract, NothingIsOnUntilItIsAskedFor) {
  EXPECT_FALSE(this->bench_.motors_have_current());
  EXPECT_FALSE(this->bench_.spindle_enabled());
  this->bench_.port.set_motors_enabled(0b111111);
  this->bench_.port.set_spindle(true, false);
  EXPECT_TRUE(this->bench_.motors_have_current());
  EXPECT_TRUE(this->bench_.spindle_enabled());
  this->bench_.port.set_motors_enabled(0);
  this->bench_.port.set_spindle(false, true);
  EXPECT_FALSE(this->bench_.motors_have_current());
  EXPECT_FALSE(this->bench_.spindle_enabled());
}

TYPED_TEST(PortContract, TheInterruptAndTheLoopReadTheSameSwitches) {
  EXPECT_EQ((InputState{}), this->bench_.port.read_inputs());
  EXPECT_FALSE(this->bench_.port.probe_contact());
  this->bench_.touch_probe(true);
  this->bench_.close_limit(1);
  EXPECT_TRUE(this->bench_.port.probe_contact());
  EXPECT_EQ(0b10, this->bench_.port.switches().first);
  EXPECT_EQ((InputState{.limits = 0b10, .probe = true}), this->bench_.port.read_inputs());
  this->bench_.touch_probe(false);
  this->bench_.press_hold(true);
  EXPECT_EQ((InputState{.limits = 0b10, .hold = true}), this->bench_.port.read_inputs());
}

}  // namespace
}  // namespace hal
