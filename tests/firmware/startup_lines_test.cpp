#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

using Lines = std::vector<std::string>;

/// Tests `$N0=` and `$N1=`, the lines that are executed at each start.
class StartupLinesTest : public ControllerTest {
 protected:
  static constexpr std::string_view kWayOut =
      "[MSG:A startup line raised the alarm: reset, $X, then clear the line by $N0= or $N1=]";
  static constexpr std::string_view kTakenBack = "[MSG:$N1 failed; its previous text is restored]";

  void restart() {
    link.outgoing.clear();
    stream("\x18");
    run(200);
  }
  /// Resets and unlocks, as an operator does after an alarm.
  void recover() {
    restart();
    EXPECT_EQ(send("$X"), "ok");
  }
  [[nodiscard]] bool was_printed(std::string_view line) const {
    return link.outgoing.find(line) != std::string::npos;
  }
  std::string stored_line(std::size_t index) {
    return std::string{StoredState{store}.load_startup_line(index).view()};
  }
};

TEST_F(StartupLinesTest, RunAfterAReset) {
  EXPECT_EQ(send("$N0=G55 G20 (inches)"), "ok");
  EXPECT_EQ(send("$N1=G6"), "error:20");
  EXPECT_EQ(stored_line(0), "G55 G20");
  EXPECT_EQ(stored_line(1), "");
  restart();
  EXPECT_EQ(printed(), (Lines{"Grbl 1.1h ['$' for help]", ">G55 G20"}));
  link.outgoing.clear();
  EXPECT_EQ(send("$G"), "ok");
  EXPECT_EQ(printed()[0], "[GC:G0 G55 G17 G20 G90 G94 G61 M5 M9 T0 F0 S0]");
  EXPECT_EQ(send("$N0="), "ok");
  restart();
  EXPECT_EQ(printed(), (Lines{"Grbl 1.1h ['$' for help]"}));
}

/// Each line begins correctly and fails later. The answer is an error or an alarm, and no part of
/// the line is stored.
TEST_F(StartupLinesTest, AreNotKeptWhereTheyFailLater) {
  EXPECT_EQ(send("$N1=G91"), "ok");
  for (const std::string_view line : {"G41.1 D20 G1 X1 F600", "G38.2 X1 F600", "G38.4 X1 F600"}) {
    link.outgoing.clear();
    send("$N1=" + std::string{line});
    run(3000);
    EXPECT_NE(machine.alarm(), Alarm::kNone) << line;
    EXPECT_TRUE(was_printed(kTakenBack)) << line << '\n' << link.outgoing;
    EXPECT_EQ(stored_line(1), "G91") << line;
    recover();
    restart();
    EXPECT_EQ(machine.state(), MachineState::kIdle) << line;
    EXPECT_TRUE(was_printed(">G91")) << link.outgoing;
  }
}

TEST_F(StartupLinesTest, AreNotKeptWhereAResetCutsThemShort) {
  stream("$N1=G91 G1 X20 F600\n");
  run(500);
  EXPECT_EQ(stored_line(1), "G91 G1 X20 F600") << "stored before it moves";
  restart();
  EXPECT_TRUE(was_printed(kTakenBack)) << link.outgoing;
  EXPECT_EQ(stored_line(1), "");
}

TEST_F(StartupLinesTest, AreKeptOnceTheyWereDoneToTheirEnd) {
  EXPECT_EQ(send("$N1=G91 G1 X2 F600"), "ok");
  run_until_idle();
  run(5);
  EXPECT_EQ(send("G38.2 X1 F600"), "ok") << "a later line that fails";
  run(3000);
  EXPECT_NE(machine.alarm(), Alarm::kNone);
  EXPECT_FALSE(was_printed(kTakenBack)) << link.outgoing;
  EXPECT_EQ(stored_line(1), "G91 G1 X2 F600");
}

/// A store can contain such lines if it came from another controller, or if a setting was changed
/// afterwards.
TEST_F(StartupLinesTest, ThatFailAtTheStartSayWhyAndLeaveAWayOut) {
  ASSERT_TRUE(StoredState{store}.save_startup_line(1, "G41.1 D20 G1 X1 F600"));
  for (int times = 0; times < 2; ++times) {
    restart();
    EXPECT_EQ(machine.alarm(), Alarm::kCompensation);
    EXPECT_TRUE(was_printed("[MSG:Startup line: since G41 or G42, element 1 is the entry"))
        << link.outgoing;
    EXPECT_TRUE(was_printed(kWayOut)) << link.outgoing;
    EXPECT_TRUE(answers().empty());
    recover();
    EXPECT_EQ(machine.state(), MachineState::kIdle) << "no startup line runs in an alarm";
  }
  EXPECT_EQ(send("$N1="), "ok");
  restart();
  EXPECT_EQ(machine.state(), MachineState::kIdle);
}

}  // namespace
}  // namespace cnc
