#include "firmware/machine/progress.hpp"

#include <gtest/gtest.h>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class ProgressTest : public ControllerTest {
 protected:
  ProgressTest() { send_all({"$32=1", "$120=1000", "M4 S500", "G1 F6000"}); }

  /// Disconnects the sender during the motion to X40 in line 12.
  void lose_the_sender() {
    stream("N11 G1 X10\nN12 X40\nN13 Y20\n");
    run(400);
    application.lose_sender();
    run(2000);
    ASSERT_EQ(machine.state(), MachineState::kDoor);
    application.begin_sender();
    run(1);
    stream("\x18");
    run(5);
    ASSERT_EQ(machine.state(), MachineState::kIdle);
    link.outgoing.clear();
  }
  std::string told() {
    link.outgoing.clear();
    EXPECT_EQ(send("$RESUME"), "ok");
    return printed().front();
  }
};

TEST_F(ProgressTest, IsNoneBeforeAnyProgram) {
  EXPECT_EQ(told(), "[RESUME:0]");
  send_all({"G1 X5"});
  run_until_idle();
  send_all({"$J=G91 X1 F1000"});
  run_until_idle();
  EXPECT_EQ(told(), "[RESUME:0]") << "of lines without a number nobody could name one";
}

TEST_F(ProgressTest, TellsTheLineAndWhereTheBeamWentDark) {
  lose_the_sender();
  const std::string words = told();
  ASSERT_EQ(words.substr(0, 12), "[RESUME:12|3") << words;
  EXPECT_EQ(words.substr(words.size() - 5), "|can]") << words;
  const double x = std::stod(words.substr(11));
  double lit_until = 0.0;
  for (const Sight& sight : sights) {
    if (sight.power > 0) lit_until = sight.position[0] / 250.0;
  }
  EXPECT_NEAR(x, lit_until, 0.11);
  EXPECT_GT(x_mm(), x + 1.0) << "braked in the dark";
}

TEST_F(ProgressTest, IsGoneWhenTheProgramEnds) {
  lose_the_sender();
  send_all({"N1 G1 X0 F6000", "N2 M2"});
  EXPECT_EQ(told(), "[RESUME:0]");
}

TEST_F(ProgressTest, OutlivesPowerOnceTheMachineStands) {
  stream("N11 G1 X10\nN12 X40\nN13 Y20\n");
  run(400);
  const int before = store.saves;
  stream("!");
  run(2000);
  EXPECT_EQ(store.saves, before + 1);
  MemoryLink other;
  Application<hal::host::RecordingPort> again{port, port, port, store, other};
  EXPECT_EQ(again.machine().progress().noted(), machine.progress().noted());
  EXPECT_EQ(again.machine().progress().noted().line.number, 12U);
  EXPECT_FALSE(again.machine().progress().can_reenter(again.machine().homed()))
      << "the position of the motors is unknown";
  stream("~");
  run_until_idle();
  send_all({"N14 M30"});
  run(5);
  Application<hal::host::RecordingPort> later{port, port, port, store, other};
  EXPECT_FALSE(later.machine().progress().noted().any());
}

TEST_F(ProgressTest, OutlivesARestartInMemoryThatIsNotCleared) {
  KeptProgress kept;
  const Progress progress{.line = 77, .steps = {1, -2, 3, -4, 5, -6}};
  kept.keep(progress);
  EXPECT_EQ(kept.progress(), progress);
  MemoryLink other;
  Application<hal::host::RecordingPort> again{port, port, port, store, other, nullptr, &kept};
  EXPECT_EQ(again.machine().progress().noted(), progress);
  // The supply may fail once more, so the progress is stored in the first cycle.
  again.poll(hal::TickCount{0});
  Application<hal::host::RecordingPort> later{port, port, port, store, other};
  EXPECT_EQ(later.machine().progress().noted(), progress);
  auto bytes = std::as_writable_bytes(std::span{&kept, 1});
  for (std::byte& byte : bytes) {
    byte ^= std::byte{0x10};
    EXPECT_FALSE(kept.progress().any());
    byte ^= std::byte{0x10};
  }
}

/// A change of the scale deletes the progress. Loading the scale at start-up does not.
TEST_F(ProgressTest, OutlivesTheSettingsThatAreLoadedWithIt) {
  KeptProgress kept;
  const Progress progress{.line = 77, .steps = {1, -2, 3, -4, 5, -6}};
  kept.keep(progress);
  EXPECT_EQ(send("$100=1600"), "ok");
  MemoryLink other;
  Application<hal::host::RecordingPort> again{port, port, port, store, other, nullptr, &kept};
  EXPECT_EQ(again.machine().settings().get(setting::kStepsPerMm), 1600.0F);
  EXPECT_EQ(again.machine().progress().noted(), progress);
  EXPECT_EQ(kept.progress(), progress);
}

TEST_F(ProgressTest, IsTakenUpOnlyWhereItIs) {
  EXPECT_EQ(send("$RESUME=12"), "error:2");
  lose_the_sender();
  EXPECT_EQ(send("$RESUME=13"), "error:2");
  EXPECT_EQ(send("$RESUME=x"), "error:2");
  EXPECT_EQ(send("$RESUME="), "error:2");
  EXPECT_EQ(send("$RESUME=12"), "ok");
  EXPECT_TRUE(machine.progress().reentry().active());
  EXPECT_EQ(send("$RESUME=0"), "ok");
  EXPECT_FALSE(machine.progress().reentry().active());
}

TEST_F(ProgressTest, IsDarkUntilThePlaceAndLitFromThereOn) {
  lose_the_sender();
  const double place = std::stod(told().substr(11));
  send_all({"$RESUME=12", "G0 X10 Y0", "M4 S500", "G1 F6000"});
  run_until_idle();
  sights.clear();
  send_all({"N12 G1 X40", "N13 Y20"});
  run_until_idle();
  double lit_from = 1000.0;
  for (const Sight& sight : sights) {
    if (sight.power > 0) lit_from = std::min(lit_from, sight.position[0] / 250.0);
  }
  EXPECT_NEAR(lit_from, place, 0.02);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
}

TEST_F(ProgressTest, AlarmsWhereAnotherProgramDoesNotPassThePlace) {
  lose_the_sender();
  send_all({"$RESUME=12", "M4 S500", "G1 F6000", "N12 G1 Y-20"});
  stream("N13 M2\n");
  run(3000);
  EXPECT_EQ(machine.alarm(), Alarm::kPlaceNotMet);
  EXPECT_EQ(at(Axis::kY), machine.motion().tool_place()[1]);
}

TEST_F(ProgressTest, AlarmsWhereNumbersLeaveThePlaceBehind) {
  lose_the_sender();
  send_all({"$RESUME=12", "M4 S500", "G1 F6000"});
  stream("N5000 G1 Y-20\n");
  run(3000);
  EXPECT_EQ(machine.alarm(), Alarm::kPlaceNotMet);
}

TEST_F(ProgressTest, IsRefusedWhereThePlaceMayBeLost) {
  stream("N11 G1 X10\nN12 X40\n");
  run(400);
  stream("\x18");
  run(50);
  send_all({"$X"});
  const std::string words = told();
  EXPECT_EQ(words.substr(words.size() - 6), "|home]") << words;
  EXPECT_EQ(send("$RESUME=12"), "error:9");
}

}  // namespace
}  // namespace cnc
