#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>

#include "hal/host/memory_store.hpp"
#include "host-sim/machine/virtual_controller.hpp"
#include "host-sim/serve/session.hpp"

namespace proof {
namespace {

using cnc::Alarm;
using cnc::MachineState;

constexpr int kPollMs = 100;
constexpr int kAllowedMs = 250;
/// Longest time until the beam is off: the permitted time, a fifth more, the cycle that notices the
/// silence, and the cycle whose segments are dark.
constexpr int kDarkMs = kAllowedMs + kAllowedMs / 5 + 2;

/// Lines, arcs, a rapid and a slow part, with the beam on for some two seconds.
constexpr std::string_view kProgram =
    "G21 G90 M4 S800\n"
    "G1 X40 F12000\n"
    "G1 Y10 S300\n"
    "G2 X20 Y-10 I-20 J0\n"
    "G0 X5 Y2\n"
    "G1 X6 F60 S1000\n"
    "M3 S500\n"
    "G1 X30 F6000\n"
    "G1 X0 Y0\n"
    "M5\n";

/// A link whose two ends are in memory.
class TextLink final : public hal::ByteStream {
 public:
  std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), incoming.size());
    for (std::size_t i = 0; i < count; ++i) into[i] = static_cast<std::byte>(incoming[i]);
    incoming.erase(0, count);
    return count;
  }
  std::size_t write(std::span<const std::byte> from) override {
    for (const std::byte byte : from) outgoing += static_cast<char>(byte);
    return from.size();
  }

  std::string incoming;
  std::string outgoing;
};

void set_laser(cnc::Machine& machine) {
  for (const auto& [number, value] : {std::pair{32, 1.0F}, {120, 2000.0F}, {121, 2000.0F}}) {
    ASSERT_TRUE(machine.change_setting(static_cast<std::uint16_t>(number), value).ok());
  }
}

class LinkWatch : public testing::Test {
 protected:
  LinkWatch() { set_laser(machine); }

  /// Polls at intervals of kPollMs, as a sender does that has sent all its lines.
  void talk(int ms) {
    for (; ms > 0; --ms) {
      if (now_ms % kPollMs == 0) say("?");
      turn();
    }
  }
  void say(std::string_view bytes) {
    link.incoming += bytes;
    last_byte_ms = now_ms;
  }
  void turn() {
    const std::size_t answered = link.outgoing.size();
    controller.turn();
    ++now_ms;
    if (link.outgoing.find("ok\r\n", answered) != std::string::npos) last_answer_ms = now_ms;
    if (controller.port().power > 0) last_light_ms = now_ms;
  }
  void wait(int ms) {
    for (; ms > 0; --ms) turn();
  }
  void wait_until_idle() {
    wait(10);  // This time suffices for the controller to read the lines.
    for (int left = 60'000; !machine.idle() && left > 0; --left) {
      if (left % kPollMs == 0) say("?");
      turn();
    }
  }

  TextLink link;
  sim::VirtualController controller{link, {}};
  cnc::Machine& machine = controller.machine();
  int now_ms = 0;
  int last_byte_ms = 0;
  int last_answer_ms = 0;
  int last_light_ms = 0;
};

TEST_F(LinkWatch, LeavesASenderThatPollsAlone) {
  say(kProgram);
  wait_until_idle();
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_GT(now_ms, 2000);
}

TEST_F(LinkWatch, LeavesOneThatPollsFourTimesASecondAlone) {
  say(kProgram);
  for (int polls = 0; polls < 40; ++polls) {
    wait(260);
    say("?");
  }
  EXPECT_TRUE(machine.idle());
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
}

/// The sender falls silent at every hundredth of a second of a job. The beam must be off within
/// kDarkMs, the machine must stop on the path, and its position must be known to the step.
TEST_F(LinkWatch, EndsAJobWhoseSenderFallsSilentAtEveryHundredthOfASecond) {
  int alarms = 0;
  for (int after = 0; after < 2400; after += 10) {
    SCOPED_TRACE(after);
    talk(4 * kPollMs);
    say(kProgram);
    talk(after);
    link.outgoing.clear();
    wait(3000);
    EXPECT_LE(last_light_ms - last_byte_ms, kDarkMs);
    EXPECT_FALSE(controller.step_timer_runs());
    if (machine.alarm() == Alarm::kLinkSilent) {
      ++alarms;
      EXPECT_NE(link.outgoing.find("ALARM:25\r\n"), std::string::npos);
      EXPECT_EQ(machine.state(), MachineState::kAlarm);
      say("$X\n");
      wait(10);
    }
    ASSERT_EQ(machine.alarm(), Alarm::kNone);
    EXPECT_EQ(machine.interpreter().position(), machine.motion().tool_place());
    say("G90 G0 X0 Y0\n");
    wait_until_idle();
    EXPECT_EQ(controller.port().position[0], 0);
    EXPECT_EQ(controller.port().position[1], 0);
    wait(10);
  }
  std::printf("%d alarms\n", alarms);
  EXPECT_GT(alarms, 150);
}

/// A sender that does not poll and is not at the end of its program. It must send a line as soon as
/// all its lines have been answered.
TEST_F(LinkWatch, EndsAJobThatIsNotFollowedUpAfterAnyOfItsCuts) {
  int ended = 0;
  for (std::size_t end = 0; end < kProgram.size(); ++end) {
    if (kProgram[end] != '\n') continue;
    const std::string_view said = kProgram.substr(0, end + 1);
    const std::size_t line = said.rfind('\n', end - 1) + 1;
    if (said.substr(line, 3) != "G1 " && said.substr(line, 3) != "G2 ") continue;
    SCOPED_TRACE(said);
    say(said);
    wait(5000);
    if (machine.alarm() == Alarm::kLinkSilent) ++ended;
    EXPECT_LE(last_light_ms - std::max(last_byte_ms, last_answer_ms), kDarkMs);
    EXPECT_EQ(controller.port().power, 0);
    say("$X\nM5\nG90 G0 X0 Y0\n");
    wait(3000);
  }
  EXPECT_EQ(ended, 5) << "the first after M3 takes less than is allowed";
}

TEST_F(LinkWatch, WaitsForEverWhereItIsToldTo) {
  ASSERT_TRUE(machine.change_setting(cnc::setting::kLinkWatchdog, 0.0F).ok());
  say(kProgram);
  wait(10'000);
  EXPECT_TRUE(machine.idle());
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
}

/// A silent sender must not stop motion with a spindle, or with the beam off, which burns nothing.
TEST_F(LinkWatch, LeavesMotionWithoutABeamAlone) {
  say("G1 X60 F1200\n");
  wait(5000);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  ASSERT_TRUE(machine.change_setting(cnc::setting::kLaserMode, 0.0F).ok());
  say("M3 S500\nG1 X0 F1200\n");
  wait(5000);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_TRUE(machine.idle());
}

/// A sender whose port or connection closes is lost immediately. This happens at every hundredth of
/// a second.
TEST(LostSender, LeavesTheBeamDarkAndThePlaceKnown) {
  constexpr int kWelcomeMs = 20;
  constexpr int kDark = 2;
  hal::host::MemoryStore store;
  sim::Session session{{}, {}, store};
  set_laser(session.controller().machine());
  const auto run = [&](int ms) {
    for (; ms > 0; --ms) session.turn();
  };
  const auto bytes = [](std::string_view text) { return std::as_bytes(std::span{text}); };
  for (int after = 0; after < 2400; after += 10) {
    SCOPED_TRACE(after);
    session.welcome_sender();
    run(kWelcomeMs);
    session.link().receive(bytes(kProgram));
    for (int ms = 0; ms < after; ++ms) {
      if (ms % kPollMs == 0) session.link().receive(bytes("?"));
      run(1);
    }
    session.lose_sender();
    run(kDark);
    for (int left = 5000; !session.calm() && left > 0; --left) {
      ASSERT_EQ(session.controller().port().power, 0) << left;
      run(1);
    }
    const cnc::Machine& machine = session.controller().machine();
    ASSERT_EQ(machine.alarm(), Alarm::kNone);
    EXPECT_EQ(machine.interpreter().position(), machine.motion().tool_place());
    session.welcome_sender();
    run(kWelcomeMs);
    session.link().receive(bytes("G90 G0 X0 Y0\n"));
    run(2000);
    EXPECT_EQ(session.controller().port().position[0], 0);
    session.lose_sender();
    run(300);
  }
}

}  // namespace
}  // namespace proof
