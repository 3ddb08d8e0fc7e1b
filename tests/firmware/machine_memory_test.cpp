#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <span>
#include <utility>

#include "firmware/machine/configuration.hpp"
#include "firmware/machine/motion_control.hpp"
#include "firmware/steps/step_generator.hpp"
#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

constexpr std::size_t kBytes = 32;
constexpr int kMaxPieces = 128;  ///< On the chip, a piece takes a millisecond.

bool finds_damage(Machine& machine) {
  for (int piece = 0; piece < kMaxPieces; ++piece) {
    if (!machine.memory().check(kBytes)) return true;
  }
  return false;
}

/// Flips a bit of an object, as radiation does, without regard to its type.
template <typename Object>
void turn(const Object& object, std::size_t byte, unsigned bit) {
  unsigned char value = 0;
  auto* const at = reinterpret_cast<unsigned char*>(const_cast<Object*>(&object)) + byte;
  std::memcpy(&value, at, 1);
  value = static_cast<unsigned char>(value ^ 1U << bit);
  std::memcpy(at, &value, 1);
}

/// Tests settings and positions whose bits change in memory without a command.
class MachineMemoryTest : public ControllerTest {
 protected:
  bool is_found() { return finds_damage(machine); }
};

TEST_F(MachineMemoryTest, ASettingIsFoundWithinAFewPieces) {
  EXPECT_FALSE(is_found());
  turn(machine.settings(), 40, 6);
  EXPECT_TRUE(is_found());
  turn(machine.settings(), 40, 6);
  EXPECT_TRUE(is_found()) << "what turns back has been wrong all the same";
}

TEST_F(MachineMemoryTest, SoAreThePowerTableAndThePlaces) {
  turn(machine.power_table(), 0, 0);
  EXPECT_TRUE(is_found());
}

TEST_F(MachineMemoryTest, APlaceThatTurnedOverIsNotStored) {
  const int saves = store.saves;
  turn(machine.interpreter().places(), 3, 7);
  run(20);
  EXPECT_EQ(saves, store.saves);
  EXPECT_TRUE(is_found());
}

TEST_F(MachineMemoryTest, WhatIsChangedByCommandIsNoDamage) {
  for (const char* line : {"$110=6000",
                           "$32=1",
                           "$PC=",
                           "G10 L2 P1 X5",
                           "G28.1",
                           "G10 L20 P2 Y1",
                           "G21 G90",
                           "$RST=#",
                           "$100=160"}) {
    EXPECT_EQ(send(line), "ok") << line;
    run(20);
    EXPECT_FALSE(is_found()) << line;
  }
  machine.toggle_block_delete();
  EXPECT_FALSE(is_found());
  send_all({"G1 X5 F3000"});
  run_until_idle();
  EXPECT_FALSE(is_found()) << "after motion";
}

TEST_F(MachineMemoryTest, AChangeDoesNotHideWhatTurnedOverBefore) {
  turn(machine.settings(), 44, 3);
  EXPECT_EQ(send("$110=6000"), "ok");
  EXPECT_TRUE(is_found());
}

/// Outputs that call a function while settings are being applied.
class BusyOutputs final : public hal::AuxiliaryOutputs {
 public:
  void set_spindle(bool, bool) override {
    if (meanwhile) std::exchange(meanwhile, {})();
  }
  void set_coolant(bool, bool) override {}
  void set_digital(std::uint8_t, bool) override {}
  void set_analog_output(std::uint8_t, std::uint16_t) override {}
  void set_motors_enabled(std::uint8_t) override {}

  std::function<void()> meanwhile;
};

// A jerk of 0 that turns into a tiny value violates no range, so the settings alone do not reveal
// it.
TEST(MachineMemory, WhatTurnsOverWhileSettingsAreAppliedIsNotTrusted) {
  for (std::size_t row = 0; row < setting_table().size(); ++row) {
    hal::host::RecordingPort port;
    BusyOutputs outputs;
    StepGenerator<hal::host::RecordingPort, 64> steps{port};
    motion::Pixels pixels;
    Machine machine{steps, pixels, outputs, port, nullptr};
    outputs.meanwhile = [&] { turn(machine.settings(), 4 * row, 0); };
    EXPECT_TRUE(machine.change_setting(setting::kRate, 6000.0F).ok());
    EXPECT_FALSE(outputs.meanwhile);
    EXPECT_TRUE(finds_damage(machine)) << "$" << setting_table()[row].number;
  }
}

// With a jerk of 2 mm/s³ the beam would stay on one point for long.
TEST_F(MachineMemoryTest, IsFoundBeforeAnyMotionThatFollowsFromIt) {
  send_all({"$32=1", "M3 S500", "G1 X1 F3000"});
  run_until_idle();
  const auto place = port.position;
  turn(machine.settings(), 40, 6);
  send_all({"G1 X2"});
  for (int turns = 0; turns < 20 && machine.memory().check(0); ++turns) run(1);
  EXPECT_FALSE(machine.memory().check(0));
  EXPECT_EQ(port.position, place);
  EXPECT_EQ(port.power, 0);
}

TEST(MotionControl, DrivesNoWayThatBeginsElsewhere) {
  hal::host::RecordingPort port;
  StepGenerator<hal::host::RecordingPort, 64> steps{port};
  const motion::Limits limits = limits_from(Settings{});
  motion::Pixels pixels;
  MotionControl motion{steps, limits, pixels};
  path::PathItem item{};
  item.request.feed_mm_s = 10.0F;
  item.request.element.start[0] = Coordinate{1 << 30};
  const auto drive = [&] {
    static_cast<void>(motion.append(item));
    motion.flush();
  };
  EXPECT_DEATH(drive(), "contract failed");
}

TEST_F(MachineMemoryTest, ABeamRestsDarkAndASpindleDoesNot) {
  EXPECT_EQ(send("$32=1"), "ok");
  EXPECT_TRUE(machine.tool().is_dark_at_rest());
  EXPECT_EQ(send("$32=0"), "ok");
  EXPECT_FALSE(machine.tool().is_dark_at_rest());
}

}  // namespace
}  // namespace cnc
