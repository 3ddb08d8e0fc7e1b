#include <gtest/gtest.h>

#include <set>

#include "hal/stm32f405/boards/btt_skr_2.hpp"
#include "hal/stm32f405/boards/btt_skr_pro_1_2.hpp"
#include "hal/stm32f405/boards/generic.hpp"
#include "hal/stm32f405/boards/mks_robin_nano_v3.hpp"
#include "hal/stm32f405/port.hpp"
#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {
namespace {

constexpr Board with_second_motors(Board board) {
  board.second_motors[1] = {pc(9), pc(10)};
  board.second_limits[1] = pc(11);
  board.outputs = {};
  return board;
}
inline constexpr Board kTwoMotors = with_second_motors(kGeneric);

template <const Board& kBoard>
struct On {
  static constexpr const Board& board = kBoard;
};

template <typename On>
class BoardPins : public testing::Test {};
using Boards = testing::Types<On<kGeneric>,
                              On<kGeneric12>,
                              On<kGeneric25>,
                              On<kGenericCan>,
                              On<kBttSkr2>,
                              On<kBttSkrPro12>,
                              On<kMksRobinNanoV30>,
                              On<kMksRobinNanoV31He1>,
                              On<kTwoMotors>>;
TYPED_TEST_SUITE(BoardPins, Boards);

TYPED_TEST(BoardPins, EachSetOfAxesStepsItsPinsAndNoOthers) {
  constexpr const Board& kBoard = TypeParam::board;
  ChipModel& chip = ModelBus::start_anew();
  Port<TypeParam::board, ModelBus> port;
  port.set_up(kFullSpeed);
  std::set<unsigned> ports;
  for (const Motor& motor : kBoard.motors) {
    if (motor.step.exists()) ports.insert(motor.step.port);
  }
  for (const Motor& motor : kBoard.second_motors) {
    if (motor.step.exists()) ports.insert(motor.step.port);
  }
  for (unsigned axes = 0; axes < 64; ++axes) {
    const auto before = chip.pins_driven_high;
    chip.writes.clear();
    port.raise_steps({static_cast<std::uint8_t>(axes)}, {static_cast<std::uint8_t>(axes)});
    EXPECT_EQ(ports.size(), chip.writes.size()) << "one store for each port";
    for (unsigned axis = 0; axis < kAxes; ++axis) {
      for (const Pin pin : {kBoard.motors[axis].step, kBoard.second_motors[axis].step}) {
        if (pin.exists()) {
          EXPECT_EQ((axes >> axis & 1U) != 0, chip.is_high(pin));
        }
      }
    }
    port.lower_steps();
    EXPECT_EQ(before, chip.pins_driven_high) << "no other pin has changed";
  }
}

TYPED_TEST(BoardPins, DirectionsAreDrivenBothWays) {
  constexpr const Board& kBoard = TypeParam::board;
  ChipModel& chip = ModelBus::start_anew();
  Port<TypeParam::board, ModelBus> port;
  port.set_up(kFullSpeed);
  port.configure({.directions = 0b101});
  for (const unsigned axes : {63U, 0U, 21U}) {
    port.set_direction({static_cast<std::uint8_t>(axes)});
    for (unsigned axis = 0; axis < kAxes; ++axis) {
      if (!kBoard.motors[axis].step.exists()) continue;
      EXPECT_EQ(((axes ^ 0b101U) >> axis & 1U) != 0, chip.is_high(kBoard.motors[axis].direction));
    }
  }
}

TYPED_TEST(BoardPins, AfterStartUpNothingIsOn) {
  constexpr const Board& kBoard = TypeParam::board;
  ChipModel& chip = ModelBus::start_anew();
  Port<TypeParam::board, ModelBus> port;
  port.set_up(kFullSpeed);
  for (const Pin pin :
       {kBoard.spindle_enable, kBoard.spindle_direction, kBoard.mist, kBoard.flood}) {
    if (!pin.exists()) continue;
    EXPECT_FALSE(chip.is_high(pin));
    EXPECT_EQ(1U, chip.mode_of(pin));
  }
  for (const Motor& motor : kBoard.motors) {
    if (motor.enable.exists()) {
      EXPECT_TRUE(chip.is_high(motor.enable)) << "drivers are enabled by a low";
    }
  }
  EXPECT_EQ((InputState{}), port.read_inputs());
}

TEST(Pins, AStepThatIsActiveLowRestsHigh) {
  ChipModel& chip = ModelBus::start_anew();
  Port<kGeneric, ModelBus> port;
  port.set_up(kFullSpeed);
  port.configure({.steps = 0b10});
  EXPECT_TRUE(chip.is_high(kGeneric.motors[1].step));
  port.raise_steps({0b11}, {});
  EXPECT_TRUE(chip.is_high(kGeneric.motors[0].step));
  EXPECT_FALSE(chip.is_high(kGeneric.motors[1].step));
  port.lower_steps();
  EXPECT_FALSE(chip.is_high(kGeneric.motors[0].step));
  EXPECT_TRUE(chip.is_high(kGeneric.motors[1].step));
}

TEST(Pins, SecondMotorsStepAlone) {
  ChipModel& chip = ModelBus::start_anew();
  Port<kTwoMotors, ModelBus> port;
  port.set_up(kFullSpeed);
  port.raise_steps({0b10}, {});
  EXPECT_FALSE(chip.is_high(kTwoMotors.second_motors[1].step));
  port.lower_steps();
  port.raise_steps({}, {0b10});
  EXPECT_FALSE(chip.is_high(kTwoMotors.motors[1].step));
  EXPECT_TRUE(chip.is_high(kTwoMotors.second_motors[1].step));
}

TEST(Pins, InputsAreLowWhenActiveAndSettingsTurnThemRound) {
  ChipModel& chip = ModelBus::start_anew();
  Port<kTwoMotors, ModelBus> port;
  port.set_up(kFullSpeed);
  chip.feed(kTwoMotors.limits[2], false);
  chip.feed(kTwoMotors.second_limits[1], false);
  chip.feed(kTwoMotors.door, false);
  EXPECT_EQ((InputState{.limits = 4, .second_limits = 2, .door = true}), port.read_inputs());
  port.configure({.limits = 0b1, .probe = true, .controls = 0b01000});
  EXPECT_EQ((InputState{.limits = 5, .second_limits = 2, .probe = true}), port.read_inputs());
}

TEST(Pins, EachControlHasItsBitOfTheSetting) {
  ChipModel& chip = ModelBus::start_anew();
  Port<kGeneric, ModelBus> port;
  port.set_up(kFullSpeed);
  chip.feed(kGeneric.hold, false);
  EXPECT_EQ((InputState{.hold = true}), port.read_inputs());
  port.configure({.controls = 0b11101});
  EXPECT_EQ((InputState{
                .door = true, .hold = true, .start = true, .reset = true, .emergency_stop = true}),
            port.read_inputs());
}

TEST(Pins, MotorsHaveCurrentByAxes) {
  ChipModel& chip = ModelBus::start_anew();
  Port<kBttSkr2, ModelBus> port;
  port.set_up(kFullSpeed);
  const auto driven_low = [&](unsigned axis) {
    return !chip.is_high(kBttSkr2.motors[axis].enable);
  };
  port.set_motors_enabled(0b00100);
  EXPECT_TRUE(driven_low(2));
  EXPECT_FALSE(driven_low(0) || driven_low(1) || driven_low(3) || driven_low(4));
  port.configure({.enables = 0b00011});
  EXPECT_TRUE(driven_low(0) && driven_low(1) && driven_low(2)) << "what is active has changed";
  port.set_motors_enabled(0b11011);
  EXPECT_TRUE(!driven_low(0) && !driven_low(1) && !driven_low(2) && driven_low(3) && driven_low(4));
}

TEST(Pins, ASharedEnableIsOnWhileAnyAxisIsToHaveCurrent) {
  ChipModel& chip = ModelBus::start_anew();
  Port<kGeneric, ModelBus> port;
  port.set_up(kFullSpeed);
  port.set_motors_enabled(0b000100);
  EXPECT_FALSE(chip.is_high(kGeneric.motors_enable));
  port.set_motors_enabled(0);
  EXPECT_TRUE(chip.is_high(kGeneric.motors_enable));
}

TEST(Pins, ARobinNanoHoldsTheSwitchOfItsUsbLow) {
  ChipModel& chip = ModelBus::start_anew();
  Port<kMksRobinNanoV30, ModelBus> port;
  port.set_up_at_rest();
  EXPECT_EQ(1U, chip.mode_of(pa(14)));
  EXPECT_FALSE(chip.is_high(pa(14)));
}

/// These pins share the limited current of the backup domain (DS8626, table 7).
TEST(Pins, PinsOfTheBackupDomainAreSlow) {
  ChipModel& chip = ModelBus::start_anew();
  for (const Pin pin : {pc(12), pc(13), pc(14), pc(15), pb(13)}) {
    PinSetUp<ModelBus>::make_output(pin, true);
    const Word speed = chip.cells[gpio::speed(pin.port)] >> (2U * pin.number) & 3U;
    const bool slow = pin.port == pc(0).port && pin.number >= 13;
    EXPECT_EQ(slow ? 0U : 1U, speed) << unsigned{pin.number};
  }
}

TEST(Pins, WithTooSlowAClockTheMachineIsHeldStopped) {
  ModelBus::start_anew();
  Port<kGeneric, ModelBus> port;
  port.set_up(Clocks{});
  EXPECT_TRUE(port.read_inputs().emergency_stop);
}

}  // namespace
}  // namespace hal::stm32f405
