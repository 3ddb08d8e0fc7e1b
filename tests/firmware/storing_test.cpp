#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

/// The fixture watches every save: none may occur while segments are queued.
class StoringTest : public ControllerTest {
 protected:
  void expect_refused() {
    const int before = store.saves;
    for (const char* line : {"$110=6000", "$N0=G21", "$I=a", "$PC=", "$RST=*", "$RST=#"}) {
      EXPECT_EQ(send(line), "error:8") << line;
    }
    EXPECT_EQ(store.saves, before);
  }
  void expect_taken() {
    for (const char* line : {"$110=6000", "$N0=G21", "$I=a", "$110=12000"}) {
      EXPECT_EQ(send(line), "ok") << line;
    }
  }
};

TEST_F(StoringTest, IsRefusedWhileMoving) {
  send_all({"G1 X5 F300"});
  run(20);
  expect_refused();
  EXPECT_FALSE(machine.idle());
  run_until_idle();
  expect_taken();
}

TEST_F(StoringTest, IsRefusedInAHoldThatHasMotionLeft) {
  send_all({"G1 X5 F300"});
  stream("!");
  run(500);
  EXPECT_EQ(machine.state(), MachineState::kHold);
  expect_refused();
  stream("~");
  run_until_idle();
  expect_taken();
}

TEST_F(StoringTest, IsRefusedInAJog) {
  EXPECT_EQ(send("$J=G91 X5 F300"), "ok");
  run(20);
  expect_refused();
  EXPECT_EQ(machine.state(), MachineState::kJog);
  run_until_idle();
  run(2);
  expect_taken();
}

TEST_F(StoringTest, IsRefusedWhileASpindleTurns) {
  send_all({"$32=0", "M3 S500"});
  run(20);
  EXPECT_TRUE(machine.idle());
  EXPECT_GT(port.power, 0);
  expect_refused();
  send_all({"M5"});
  expect_taken();
}

TEST_F(StoringTest, IsAllowedWhereABeamWaitsForMotion) {
  send_all({"$32=1", "M4 S500"});
  run(20);
  expect_taken();
}

TEST_F(StoringTest, WaitsForStandstillWithPlaces) {
  send_all({"G1 X5 F300", "G10 L2 P1 X1", "G1 X10", "G28.1", "G1 X12", "G30.1"});
  EXPECT_TRUE(store.records().empty());
  run_until_idle();
  run(2);
  EXPECT_EQ(store.records().size(), 3U);
}

TEST_F(StoringTest, WaitsWithPlacesUntilTheSpindleIsOff) {
  send_all({"$32=0", "M3 S500", "G10 L2 P1 X1"});
  run(100);
  EXPECT_FALSE(store.records().contains(0x4000));
  send_all({"M5"});
  run(2);
  EXPECT_TRUE(store.records().contains(0x4000));
}

TEST_F(StoringTest, KeepsAStartupLineBeforeItMovesAnything) {
  EXPECT_EQ(send("$N0=G91 G1 X1 F300"), "ok");
  run_until_idle();
  send_all({"$32=0"});
  EXPECT_EQ(send("$N1=M3 S100"), "ok");
  send_all({"M5"});
  EXPECT_EQ(send("$N0=G6"), "error:20") << "a line that cannot be done";
  link.outgoing.clear();
  EXPECT_EQ(send("$N"), "ok");
  EXPECT_EQ(printed().front(), "$N0=G91 G1 X1 F300") << "and the one before stays";
}

/// `$#` lists the radii with the positions, before and after power-up.
TEST_F(StoringTest, KeepsTheRadiiOfTools) {
  send_all({"G10 L1 P3 R1.5", "G10 L1 P12 R.25"});
  run(20);
  StoredState again{store};
  EXPECT_EQ(again.load_places(), machine.interpreter().places());
  link.outgoing.clear();
  EXPECT_EQ(send("$#"), "ok");
  EXPECT_NE(link.outgoing.find("[TOOL:3|1.500]\r\n[TOOL:12|0.250]\r\n"), std::string::npos)
      << link.outgoing;
  EXPECT_EQ(send("$RST=#"), "ok");
  run(20);
  EXPECT_EQ(StoredState{store}.load_places(), gcode::StoredPlaces{});
  EXPECT_EQ(machine.interpreter().places(), gcode::StoredPlaces{});
}

}  // namespace
}  // namespace cnc
