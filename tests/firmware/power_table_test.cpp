#include "planner/motion/block/power_table.hpp"

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class PowerTableStatements : public ControllerTest {
 protected:
  std::string listed() {
    link.outgoing.clear();
    send("$PC");
    return printed().empty() ? "nothing" : printed().front();
  }
  std::string reason_of(std::string_view line) {
    link.outgoing.clear();
    const std::string answer = send(line);
    return answer + " " + (printed().empty() ? "" : printed().front());
  }
  /// Returns the duty while a long line is driven at its feed.
  double duty_at_speed(std::string_view spindle) {
    send_all({"$120=1000", "G21 G91 F3000", spindle, "G1 X20"});
    run(200);
    const double duty = port.power / 65'535.0;
    run_until_idle();
    return duty;
  }
};

TEST_F(PowerTableStatements, IsEmptyAsDelivered) { EXPECT_EQ(listed(), "$PC="); }

TEST_F(PowerTableStatements, SaysWhatItWasGiven) {
  EXPECT_EQ(send("$PC=10:0, 20:5.5,50.25:18, 90:40.125"), "ok");
  EXPECT_EQ(listed(), "$PC=10:0,20:5.5,50.25:18,90:40.125");
  EXPECT_EQ(send("$pc ="), "ok");
  EXPECT_EQ(listed(), "$PC=");
}

TEST_F(PowerTableStatements, RefusesWithAReason) {
  EXPECT_EQ(send("$PC=10:1,50:20"), "ok");
  const std::vector<std::pair<const char*, const char*>> cases{
      {"$PC=10:5,9:6", "the duty must rise"},
      {"$PC=10:5,20:5", "the watts must rise"},
      {"$PC=0:5,20:6", "no light"},
      {"$PC=101:5", "at most 100 percent"},
      {"$PC=50:10001", "at most 10000 W"},
      {"$PC=10:0", "the watts must rise"},
      {"$PC=10:0,", "the watts must rise"},
      {"$PC=10", "not a list"},
      {"$PC=10:", "not a list"},
      {"$PC=-1:4", "not a list"},
      {"$PC=10.001:4", "not a list"},
      {"$PC=10:4;20:5 is a comment", ""},
      {"$PC=10:4 20:5", "a comma is missing"},
      {"$PC=ten:4", "not a list"},
      {"$PC=1:1,2:2,3:3,4:4,5:5,6:6,7:7,8:8,9:9,10:10,11:11,12:12,13:13,14:14,15:15,16:16,17:17",
       "at most 16 points"}};
  for (const auto& [line, reason] : cases) {
    const std::string said = reason_of(line);
    if (*reason == '\0') {
      EXPECT_EQ(said.substr(0, 2), "ok") << line;
      EXPECT_EQ(send("$PC=10:1,50:20"), "ok");
      continue;
    }
    EXPECT_EQ(said.substr(0, 7), "error:2") << line;
    EXPECT_NE(said.find(reason), std::string::npos) << line << " got " << said;
    EXPECT_EQ(listed(), "$PC=10:1,50:20") << "a refused table changes nothing";
  }
}

TEST_F(PowerTableStatements, IsRefusedWhileTheMachineMoves) {
  send_all({"G21 G91 F600", "G1 X5"});
  EXPECT_EQ(send("$PC=100:40"), "error:8");
}

TEST_F(PowerTableStatements, MakesSTheShareOfTheGreatestWatts) {
  send_all({"$32=1", "$PC=10:0,20:5,50:25,90:40"});
  EXPECT_NEAR(duty_at_speed("M3 S1000"), 0.9, 1.0e-4);
  EXPECT_NEAR(duty_at_speed("M3 S625"), 0.5, 1.0e-4);
  EXPECT_NEAR(duty_at_speed("M4 S125"), 0.2, 1.0e-4);
  EXPECT_NEAR(duty_at_speed("M4 S0"), 0.0, 1.0e-9) << "dark is dark, whatever the threshold";
}

TEST_F(PowerTableStatements, ReportsTheShareAsS) {
  send_all({"$32=1", "$PC=10:0,20:5,50:25,90:40", "G21 G91 F3000", "M3 S625", "G1 X20"});
  run(200);
  EXPECT_NEAR(machine.spindle_now(), 625.0F, 0.5F);
}

TEST_F(PowerTableStatements, LeavesASpindleAlone) {
  send_all({"$PC=10:0,20:5,50:25,90:40", "M3 S500"});
  run_until_idle();
  EXPECT_NEAR(port.power / 65'535.0, 0.5, 1.0e-4);
}

TEST_F(PowerTableStatements, SurvivesPower) {
  send("$PC=10:0,20:5.5,90:40.125");
  MemoryLink other;
  Application<hal::host::RecordingPort> again{port, port, port, store, other};
  other.incoming = "$PC\n";
  for (std::uint32_t turn = 0; turn < 20; ++turn) again.poll(hal::TickCount{1000 * turn});
  EXPECT_NE(other.outgoing.find("$PC=10:0,20:5.5,90:40.125\r\n"), std::string::npos);
}

TEST_F(PowerTableStatements, GoesWithTheSettings) {
  send("$PC=10:0,20:5.5,90:40.125");
  link.outgoing.clear();
  send("$RST=$");
  run(100);
  EXPECT_EQ(listed(), "$PC=");
  EXPECT_TRUE(store.records().empty());
}

TEST_F(PowerTableStatements, ADamagedRecordIsNone) {
  ASSERT_TRUE(store.save(0x5200, std::vector<std::byte>(12, std::byte{0x10})));
  StoredState state{store};
  EXPECT_TRUE(state.load_power_table().points().empty());
  EXPECT_TRUE(state.damaged());
}

class BeamFloor : public PowerTableStatements {};

TEST_F(BeamFloor, KeepsALitBeamOfM4FromGoingOut) {
  send_all({"$32=1", "$854=12", "G21 G91 F12000", "M4 S1000"});
  sights.clear();
  send("G1 X3");
  run_until_idle();
  ASSERT_GT(sights.size(), 100U);
  for (const Sight& sight : sights) {
    if (sight.position[0] == 0 || sight.power == 0) continue;
    EXPECT_GE(sight.power, 0.12 * 65'535 - 1.0);
  }
  EXPECT_EQ(port.power, 0);
}

TEST_F(BeamFloor, NeverLightsABeamWhoseSIsZeroNorARapid) {
  send_all({"$32=1", "$854=12", "G21 G91 F3000", "M4 S0"});
  sights.clear();
  send_all({"G1 X3", "S500", "G0 X3", "M3 S0", "G1 X1"});
  run_until_idle();
  for (const Sight& sight : sights) EXPECT_EQ(sight.power, 0);
}

TEST_F(BeamFloor, DoesNotTouchM3) {
  send_all({"$32=1", "$854=50"});
  EXPECT_NEAR(duty_at_speed("M3 S100"), 0.1, 1.0e-4);
}

}  // namespace
}  // namespace cnc
