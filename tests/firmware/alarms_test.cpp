#include "firmware/protocol/code_texts.hpp"
#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

/// Tests the lines that a sender receives when an alarm is raised, one alarm after the other.
class AlarmsTest : public ControllerTest {
 protected:
  /// Sets switches that close beyond `steps`, and a quick homing cycle.
  void prepare_homing(std::int32_t steps) {
    send_all({"$22=1", "$25=3000", "$24=500", "$26=5", "$130=20", "$131=20", "$132=20"});
    plate = [this, steps](const auto& position) {
      unsigned closed = 0;
      for (unsigned axis = 0; axis < 3; ++axis) closed |= position[axis] > steps ? 1U << axis : 0U;
      port.limits.first = static_cast<std::uint8_t>(closed);
      return false;
    };
    link.outgoing.clear();
  }
  [[nodiscard]] bool told(const std::string& words) const {
    return link.outgoing.find(words + "\r\n") != std::string::npos;
  }
  void reset() {
    stream("\x18");
    run(50);
  }
};

/// A store as after a power-up that found damage.
class DamagedStore final : public hal::host::MemoryStore {
 public:
  [[nodiscard]] bool damaged() const override { return true; }
};

TEST(DamagedStoreTest, IsAnAlarmThatWantsAReset) {
  DamagedStore store;
  hal::host::RecordingPort port;
  MemoryLink link;
  Application<hal::host::RecordingPort> application{port, port, port, store, link};
  const auto talk = [&](std::string_view lines) {
    link.outgoing.clear();
    link.incoming = lines;
    for (std::uint32_t k = 0; k < 50; ++k) application.poll(hal::TickCount{1000 * k});
    return link.outgoing;
  };
  const std::string said = talk("$X\nG0 X1\n");
  EXPECT_NE(said.find("ALARM:28\r\n[MSG:Reset to continue]"), std::string::npos) << said;
  EXPECT_NE(
      said.find(
          "[MSG:The store is damaged. Check settings and offsets, and store one of them again.]"),
      std::string::npos)
      << said;
  EXPECT_EQ(said.find("ok"), std::string::npos) << said;
  const std::string after = talk("\x18$X\nG0 X1\n");
  EXPECT_NE(after.find("damaged"), std::string::npos) << "until it is unlocked: " << after;
  EXPECT_EQ(talk("\x18").find("damaged"), std::string::npos);
  EXPECT_NE(after.find("[MSG:Caution: Unlocked]\r\nok\r\nok"), std::string::npos) << after;
}

TEST_F(AlarmsTest, HardLimit) {
  send("$21=1");
  send("G1 X50 F600");
  run(50);
  port.limits.first = 1;
  run(100);
  EXPECT_TRUE(told("ALARM:1\r\n[MSG:Reset to continue]")) << link.outgoing;
  EXPECT_EQ(send("$X"), "error:9");
  reset();
  EXPECT_TRUE(told("Grbl 1.1h ['$' for help]\r\n[MSG:'$H'|'$X' to unlock]")) << link.outgoing;
  port.limits.first = 0;
  run(50);
  EXPECT_EQ(send("$X"), "ok");
}

TEST_F(AlarmsTest, SoftLimit) {
  prepare_homing(500);
  EXPECT_EQ(send("$H"), "ok") << link.outgoing;
  send("$20=1");
  send("G0 X-500");
  run(500);
  EXPECT_TRUE(told("ALARM:2\r\n[MSG:Reset to continue]")) << link.outgoing;
}

TEST_F(AlarmsTest, HomingCutShort) {
  prepare_homing(500);
  stream("$H\n");
  run(100);
  stream("?");
  run(1);
  EXPECT_NE(link.outgoing.find("<Home|"), std::string::npos);
  reset();
  EXPECT_TRUE(told("ALARM:6")) << link.outgoing;
  EXPECT_EQ(send("$X"), "ok");
  stream("$H\n");
  run(100);
  port.panel.door = true;
  run(100);
  EXPECT_TRUE(told("ALARM:7")) << link.outgoing;
}

TEST_F(AlarmsTest, HomingThatFindsNoSwitch) {
  prepare_homing(1'000'000);
  EXPECT_EQ(send("$H"), "error:9");
  EXPECT_TRUE(told("ALARM:9\r\n[MSG:0: homing has failed]\r\nerror:9")) << link.outgoing;
}

TEST_F(AlarmsTest, HomingWithASwitchThatStaysClosed) {
  prepare_homing(500);
  plate = [this](const auto& position) {
    if (position[2] > 500) port.limits.first = 4;
    return false;
  };
  EXPECT_EQ(send("$H"), "error:9");
  EXPECT_TRUE(told("ALARM:8")) << link.outgoing;
}

TEST_F(AlarmsTest, HomingRequiredAtTheStart) {
  send_all({"$22=5"});
  link.outgoing.clear();
  reset();
  EXPECT_TRUE(told("ALARM:11")) << link.outgoing;
  EXPECT_TRUE(told("[MSG:'$H'|'$X' to unlock]")) << link.outgoing;
}

TEST_F(AlarmsTest, EmergencyStop) {
  port.panel.emergency_stop = true;
  run(50);
  EXPECT_TRUE(told("ALARM:24")) << link.outgoing;
  EXPECT_EQ(send("G0 X1"), "error:9");
  EXPECT_EQ(send("$X"), "error:79");
}

TEST_F(AlarmsTest, MotionThatStarves) {
  send("G1 X50 F600");
  run(20);
  for (int k = 0; k < 2'000'000 && port.position[0] < 2000; ++k) application.on_step_interrupt();
  run(20);
  EXPECT_TRUE(told("ALARM:23")) << link.outgoing;
}

}  // namespace
}  // namespace cnc
