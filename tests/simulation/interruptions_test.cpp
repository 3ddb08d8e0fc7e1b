#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/support/laser_bench.hpp"
#include "tests/support/random_motor_settings.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::Alarm;
using cnc::MachineState;

/// Cancels a jog at every hundredth of a second. The position must be known to the step, and the
/// motion back must end at the start.
TEST(JogCancel, AtEveryHundredthOfASecondLosesNoStep) {
  MachineBench bench;
  for (int after = 0; after < 900; after += 10) {
    SCOPED_TRACE(after);
    ASSERT_FALSE(bench.machine().jog("X20 Y-7 F3000").has_value());
    ASSERT_FALSE(bench.machine().jog("X25 Y0 F2000").has_value());
    bench.run(after);
    bench.machine().jog_cancel();
    for (int left = 2000; bench.machine().state() == MachineState::kJog && left > 0; --left) {
      bench.run(1);
    }
    ASSERT_EQ(bench.machine().state(), MachineState::kIdle);
    EXPECT_EQ(bench.machine().interpreter().position(), bench.machine().motion().tool_place());
    bench.send("G0 X0 Y0");
    bench.finish();
    EXPECT_EQ(bench.motor(0), 0);
    EXPECT_EQ(bench.motor(1), 0);
  }
}

/// A line that arrives while a door stops a jog must wait until the end of the jog is known,
/// because it begins there.
TEST(Door, KeepsLinesWaitingUntilAJogHasStopped) {
  MachineBench bench;
  ASSERT_FALSE(bench.machine().jog("X200 F6000").has_value());
  bench.run(300);
  bench.controller.panel().door = true;
  for (int left = 50; bench.machine().state() != MachineState::kDoor && left > 0; --left) {
    bench.run(1);
  }
  ASSERT_EQ(bench.machine().state(), MachineState::kDoor);
  EXPECT_TRUE(bench.machine().busy());
  for (int left = 2000; bench.machine().busy() && left > 0; --left) bench.run(1);
  EXPECT_EQ(bench.machine().interpreter().position(), bench.machine().motion().target());
  EXPECT_FALSE(bench.machine().accept("G91 G1 X1 F6000").has_value());
  bench.run(200);
  bench.controller.panel() = {};
  bench.run(100);
  for (int left = 20; bench.machine().state() != MachineState::kIdle && left > 0; --left) {
    bench.machine().resume();
    bench.run(500);
  }
  EXPECT_EQ(bench.machine().state(), MachineState::kIdle);
  EXPECT_EQ(bench.machine().interpreter().position(), bench.machine().motion().target());
}

/// An operator, a door and a sender that act at random times.
class Chaos {
 public:
  explicit Chaos(std::uint64_t seed) : random_{seed} {
    // One machine in three has shapers or backlash. One in two has a beam delay, positive or
    // negative, on or off.
    if (seed % 3 == 0) bench_.set(random_motor_settings(random_));
    if (seed % 2 == 0) return;
    bench_.set({{854, random_.between(0.0, 10.0)},
                {855, random_.between(0.0, 5000.0)},
                {856, random_.between(0.0, 5000.0)},
                {857, random_.between(-5000.0, 5000.0)}});
  }

  void run(int turns) {
    while (turns-- > 0 && !too_many_failures()) {
      if (random_.chance(0.02)) meddle();
      if (random_.chance(0.002)) quiet_ = !quiet_;
      if (random_.chance(0.01)) help();
      if (!quiet_ && random_.chance(0.3)) offer_line();
      bench_.run(1);
      check();
    }
  }

  /// Brings the machine back to idle from any state, as an operator would.
  void recover() {
    bench_.controller.panel() = {};
    cnc::Machine& machine = bench_.machine();
    for (int left = 300; machine.state() != MachineState::kIdle && left > 0; --left) {
      if (machine.state() == MachineState::kSleep || machine.needs_reset()) machine.reset();
      if (machine.state() == MachineState::kCheck) machine.toggle_check_mode();
      if (machine.switches().single_block) machine.switches().toggle_single_block();
      bench_.run(100);
      static_cast<void>(machine.unlock());
      machine.resume();
      bench_.run(100);
    }
    EXPECT_EQ(machine.state(), MachineState::kIdle) << "stuck";
    EXPECT_FALSE(machine.busy());
    EXPECT_EQ(machine.interpreter().position(), machine.motion().target());
  }

  LaserBench& bench() { return bench_; }
  // Number of cycles with the beam on, and in each state: they show that the test reaches all
  // states.
  int beam_turns = 0;
  std::array<int, 10> state_turns{};

 private:
  std::string place() {
    const double y = random_.between(-40.0, 0.0);
    const double x = random_.between(-62.0, 1.0);
    return " X" + std::to_string(x) + " Y" + std::to_string(y);
  }

  void offer_line() {
    cnc::Machine& machine = bench_.machine();
    if (machine.busy() || machine.locked()) return;
    const std::array lines{"G1 F9000 S800" + place(),
                           "G1 F6000" + place(),
                           "G0" + place(),
                           "G2 F5000 R80" + place(),
                           std::string{"M3 S900"},
                           std::string{"M4 S500"},
                           std::string{"M5"},
                           std::string{"G4 P0.05"},
                           std::string{"M0"},
                           std::string{"M6 T3"},
                           std::string{"M8"},
                           std::string{"M30"}};
    const std::size_t which = random_.chance(0.85) ? random_.below(6) : random_.below(lines.size());
    static_cast<void>(machine.accept(lines[which]));
  }

  /// Acts so that the present work ends, in order to reach all states.
  void help() {
    cnc::Machine& machine = bench_.machine();
    bench_.controller.panel() = {};
    if (machine.state() == MachineState::kSleep || machine.needs_reset()) machine.reset();
    static_cast<void>(machine.unlock());
    if (!quiet_ || machine.busy() || !machine.idle()) return machine.resume();
    if (random_.chance(0.2)) {
      static_cast<void>(machine.toggle_check_mode());
    } else if (machine.why_not_home(0) == cnc::HomingRefusal::kNone && random_.chance(0.2)) {
      machine.home(0);
    } else {
      static_cast<void>(machine.jog("F6000" + place()));
    }
  }

  void meddle() {
    cnc::Machine& machine = bench_.machine();
    hal::InputState& panel = bench_.controller.panel();
    switch (random_.below(random_.chance(0.2) ? 17 : 9)) {
      case 0:
        return machine.feed_hold();
      case 1:
      case 2:
      case 3:
        return machine.resume();
      case 4:
        machine.set_overrides({.feed = 10 + static_cast<int>(random_.below(190)),
                               .rapid = 25,
                               .power = 10 + static_cast<int>(random_.below(190))});
        return;
      case 5:
        return machine.jog_cancel();
      case 6:
        if (!machine.busy()) static_cast<void>(machine.jog("F6000" + place()));
        return;
      case 7:
        return machine.toggle_spindle_stop();
      case 8:
        static_cast<void>(machine.unlock());
        return;
      case 9:
        panel.door = !panel.door;
        return;
      case 10:
        machine.reset();
        return;
      case 11:
        static_cast<void>(machine.sleep());
        return;
      case 12:
        static_cast<void>(machine.toggle_check_mode());
        return;
      case 13:
        if (machine.why_not_home(0) == cnc::HomingRefusal::kNone) machine.home(0);
        return;
      case 14:
        panel.emergency_stop = !panel.emergency_stop;
        return;
      case 15:
        return machine.switches().toggle_single_block();
      default:
        return machine.toggle_coolant({.flood = true});
    }
  }

  /// Checks the machine after each millisecond.
  void check() {
    cnc::Machine& machine = bench_.machine();
    const std::uint16_t power = bench_.controller.port().power;
    beam_turns += power > 0 ? 1 : 0;
    ++state_turns[static_cast<std::size_t>(machine.state())];
    if (!bench_.controller.step_timer_runs()) {
      EXPECT_EQ(power, 0) << "beam on at rest";
    }
    switch (machine.state()) {
      case MachineState::kRun:
      case MachineState::kHold:
        break;
      default:
        EXPECT_EQ(power, 0) << "beam on in state " << static_cast<int>(machine.state());
    }
    EXPECT_NE(machine.alarm(), Alarm::kStarved);
    EXPECT_NE(machine.alarm(), Alarm::kHomingNoSwitch);
    if (machine.homed() == 7) {
      EXPECT_LE(machine.motion().tool_place()[0].nanometres(), 4000);
    }
  }

  Random random_;
  LaserBench bench_;
  bool quiet_ = false;  ///< Whether the sender is pausing.
};

/// Number of cycles with the beam on, and in each state.
struct ChaosTurns {
  int beam = 0;
  std::array<int, 10> state{};
};

ChaosTurns interrupt(const Trials& trials) {
  ChaosTurns turns;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Chaos chaos{seed};
    chaos.run(6000);
    chaos.recover();
    turns.beam += chaos.beam_turns;
    for (std::size_t i = 0; i < turns.state.size(); ++i) turns.state[i] += chaos.state_turns[i];
  }
  std::printf("interruptions: the beam was on in %d turns\n", turns.beam);
  for (const int in_state : turns.state) std::printf(" %d", in_state);
  std::printf(" turns in the states\n");
  return turns;
}

TEST(Interruptions, OfAnyKindLeaveTheBeamOffAtRestAndTheMachineUsable) { interrupt(Trials{40}); }

// This fixed range of seeds must reach every state. Other seeds may hardly reach one, which would
// be no fault.
TEST(Interruptions, ReachEveryStateOften) {
  const Trials trials{40, Trials::Range::kFixed};
  const ChaosTurns turns = interrupt(trials);
  if (trials.count() < 40) return;
  EXPECT_GT(turns.beam, 1000);
  for (const int in_state : turns.state) EXPECT_GT(in_state, 100);
}

}  // namespace
}  // namespace proof
