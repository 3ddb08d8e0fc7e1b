#include <set>

#include "tests/firmware/controller_test.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

/// Tests realtime commands and requests for a report during other activities.
using RealtimeTest = ControllerTest;

TEST_F(RealtimeTest, TheResetButtonForgetsTheLinesThatWait) {
  stream("G91 G0 X1\nM0\nX7\nX7\nX7 (and half a li");
  run(500);
  ASSERT_EQ(machine.state(), MachineState::kHold);
  port.panel.reset = true;
  run(100);
  port.panel.reset = false;
  run(100);
  EXPECT_EQ(printed().back(), "Grbl 1.1h ['$' for help]");
  EXPECT_EQ(machine.state(), MachineState::kIdle) << "at rest the place is known";
  stream("ne)\n");
  run(1000);
  EXPECT_EQ(port.position[0], 250) << "nothing of what waited is done";
}

TEST_F(RealtimeTest, HoldsAndResumes) {
  send("G1 X5 F600");
  run(100);
  stream("!");
  run(200);
  EXPECT_EQ(report().substr(0, 7), "<Hold:0");
  const auto place = port.position;
  run(200);
  EXPECT_EQ(port.position, place);
  stream("~");
  run_until_idle();
  EXPECT_EQ(x_mm(), 5.0);
}

TEST_F(RealtimeTest, DoesHoldAndResumeOfOneTurnInTheirOrder) {
  send("G1 X5 F600");
  run(100);
  stream("!~");
  run_until_idle();
  EXPECT_EQ(x_mm(), 5.0);
}

TEST_F(RealtimeTest, IgnoresAJogCancelThatCancelsNothing) {
  send("G1 X5 F600");
  stream("\x85");
  run_until_idle();
  EXPECT_EQ(x_mm(), 5.0);
}

// bCNC sends this after every job.
TEST_F(RealtimeTest, KeepsThePlaceThroughAResetWhileHeld) {
  send("G1 X5 F600");
  run(100);
  stream("!");
  run(1000);
  const auto place = port.position;
  link.outgoing.clear();
  stream("\x18");
  run(20);
  EXPECT_EQ(printed(), (std::vector<std::string>{"Grbl 1.1h ['$' for help]"}));
  EXPECT_EQ(send("$X"), "ok");
  EXPECT_EQ(send("G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0"), "ok");
  EXPECT_EQ(send("G43.1Z0"), "ok");
  EXPECT_EQ(port.position, place);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
}

TEST_F(RealtimeTest, RaisesAnAlarmForAResetWhileMoving) {
  send("G1 X50 F600");
  run(100);
  link.outgoing.clear();
  stream("\x18");
  run(50);
  EXPECT_EQ(printed(),
            (std::vector<std::string>{
                "ALARM:3", "Grbl 1.1h ['$' for help]", "[MSG:'$H'|'$X' to unlock]"}));
  EXPECT_EQ(send("G0 X1"), "error:9");
  EXPECT_EQ(send(""), "ok");
  EXPECT_EQ(send("$J=G91 X1 F100"), "error:9");
  link.outgoing.clear();
  EXPECT_EQ(send("$X"), "ok");
  EXPECT_EQ(printed().front(), "[MSG:Caution: Unlocked]");
  EXPECT_EQ(send("G0 X1"), "ok");
}

TEST_F(RealtimeTest, ForgetsTheLinesBeforeAReset) {
  stream("G4 P10\nG0 X1\nG0 X2\n");
  run(20);
  stream("\x18");
  run(50);
  EXPECT_EQ(answers().size(), 0U);
  EXPECT_TRUE(machine.idle());
  EXPECT_EQ(send("$G"), "ok");
}

TEST_F(RealtimeTest, SlipsReportsIntoListingsOnASlowLink) {
  stream("$ES\n");
  for (int k = 0; k < 1000; ++k) {
    link.room = 12;  // Bytes per millisecond: 115200 Bd.
    if (k % 50 == 0) stream("?");
    run(1);
  }
  link.room = 100'000;
  run(100);
  int reports = 0;
  for (const std::string& line : printed()) reports += line.front() == '<' ? 1 : 0;
  EXPECT_EQ(reports, 20);
  EXPECT_EQ(answers(), std::vector<std::string>{"ok"});
}

// In every state of the machine, a request is answered by a report within 20 ms.
TEST_F(RealtimeTest, AnswersEveryRequestAtOnceInEveryState) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  const char* const doings[]{"G1 X5 F3000\n",
                             "G1 X0\n",
                             "!",
                             "~",
                             "\x18",
                             "$X\n",
                             "$$\n",
                             "$ES\n",
                             "$C\n",
                             "$SLP\n",
                             "G4 P0.05\n",
                             "M0\n",
                             "\x84",
                             "$J=G91 X1 F600\n",
                             "\x85",
                             "G38.3 Z-1 F300\n",
                             "M6 T1\n",
                             "\xA3",
                             "$H\n",
                             "M3 S100\n"};
  send("$22=1");  // No switch is near, so homing takes long.
  std::size_t asked = 0;
  std::set<std::string> states;
  for (; asked < 10'000; ++asked) {
    if (random.chance(0.3)) stream(doings[random.below(std::size(doings))]);
    run(static_cast<int>(random.below(10)));
    link.outgoing.clear();
    stream("?");
    run(2);
    const std::size_t begin = link.outgoing.find('<');
    ASSERT_NE(begin, std::string::npos) << "request " << asked;
    states.insert(link.outgoing.substr(begin, link.outgoing.find_first_of("|:", begin) - begin));
    EXPECT_LT(link.incoming.size(), Receiver::kRealBytes);
  }
  for (const char* state : {"<Idle",
                            "<Run",
                            "<Hold",
                            "<Alarm",
                            "<Check",
                            "<Sleep",
                            "<Door",
                            "<Jog",
                            "<Tool",
                            "<Home"}) {
    EXPECT_TRUE(states.contains(state)) << state;
  }
}

}  // namespace
}  // namespace cnc
