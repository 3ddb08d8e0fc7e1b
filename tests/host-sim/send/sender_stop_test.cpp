#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "host-sim/machine/virtual_controller.hpp"
#include "host-sim/send/sender.hpp"

namespace sim {
namespace {

using std::chrono::milliseconds;

/// The controller's end of a link without delay.
class DirectLink final : public hal::ByteStream {
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

/// Runs a controller and a sender in steps of a millisecond.
class StopBench {
 public:
  explicit StopBench(const std::vector<std::string>& lines) {
    set(22, 1.0F);  // Enables homing.
    std::vector<JobLine> job;
    for (const std::string& line : lines) job.push_back({.text = line, .number = job.size() + 1});
    sender.emplace(job, SendOptions{}, now_);
  }

  void set(std::uint16_t number, float value) {
    EXPECT_TRUE(controller.machine().change_setting(number, value).ok());
  }
  void turn() {
    while (!sender->output().empty() && link.incoming.size() < 64) {
      const std::string part{sender->output()};
      link.incoming += part;
      sender->wrote(part.size());
    }
    controller.turn();
    std::string said;
    said.swap(link.outgoing);
    sender->receive(said, now_);
    sender->attend(now_);
    ++now_;
  }
  /// Returns the milliseconds until `done` holds; more than a minute if it never does.
  int until(const std::function<bool()>& done) {
    int waited = 0;
    for (; !done() && waited < 60'001; ++waited) turn();
    return waited;
  }
  [[nodiscard]] std::string_view state() const { return sender->machine_state(); }
  [[nodiscard]] bool moves() const { return controller.step_timer_runs(); }

 private:
  milliseconds now_{0};

 public:
  DirectLink link;
  VirtualController controller{link, MachineModel{}};
  std::optional<Sender> sender;
};

struct StopCase {
  const char* name;
  const char* state;  ///< State of the machine in which the job is stopped.
  std::vector<std::string> lines;
  int max_ms;  ///< Greatest duration of the stop, ms.
  bool door = false;
  /// True for homing alone: it can end only with an alarm, which loses the position.
  bool alarm = false;
};

std::vector<std::string> checked_lines() {
  std::vector<std::string> lines{"$C", "G91F6000"};
  lines.resize(20'000, "G1X0.1");
  return lines;
}

class SenderStop : public testing::TestWithParam<StopCase> {};

TEST_P(SenderStop, LeavesNothingThatCouldGoOn) {
  const StopCase& wanted = GetParam();
  StopBench bench{wanted.lines};
  ASSERT_LE(bench.until([&] {
    if (wanted.door && bench.moves()) bench.controller.panel().door = true;
    return bench.state().starts_with(wanted.state) &&
           !bench.state().starts_with(std::string{wanted.state} + ":2");
  }),
            60'000)
      << bench.state();
  for (int ms = 0; ms < 100; ++ms) bench.turn();
  bench.sender->abort();
  const int lasted = bench.until([&] { return bench.sender->over(); });
  EXPECT_LE(lasted, wanted.max_ms);
  EXPECT_EQ(bench.sender->state(), Sender::State::kFailed);
  EXPECT_NE(bench.sender->trouble().find("aborted"), std::string::npos) << bench.sender->trouble();
  bench.controller.panel().door = false;
  for (int ms = 0; ms < 50; ++ms) bench.turn();
  EXPECT_EQ(bench.controller.machine().state(),
            wanted.alarm  ? cnc::MachineState::kAlarm
            : wanted.door ? cnc::MachineState::kDoor  // The door was open at the reset.
                          : cnc::MachineState::kIdle);
  const auto stood = bench.controller.port().position;
  bench.link.incoming += "~";
  for (int ms = 0; ms < 3000; ++ms) bench.turn();
  EXPECT_EQ(bench.controller.port().position, stood) << "a resume must drive nothing";
}

INSTANTIATE_TEST_SUITE_P(
    InAnyState,
    SenderStop,
    testing::Values(StopCase{"Run", "Run", {"G91F3000", "G1X100", "G1X5"}, 1'500},
                    StopCase{"Hold", "Hold:0", {"G91F6000", "G1X1", "M0", "G1X5", "G1X5"}, 300},
                    StopCase{"Tool", "Tool", {"G91F6000", "M6T1", "G1X5", "G1X5"}, 300},
                    StopCase{"ToolWithUnits", "Tool", {"M6T1", "G20", "G91", "G1X1F100"}, 300},
                    StopCase{"Door", "Door", {"G91F3000", "G1X100", "G1X5"}, 1'500, true},
                    StopCase{"Home", "Home", {"$H", "G91F6000", "G1X-5"}, 300, false, true},
                    StopCase{"Check", "Check", checked_lines(), 300},
                    StopCase{"Jog", "Jog", {"$J=G91X100F3000", "$J=G91X100F3000"}, 1'500},
                    StopCase{"Sleep", "Sleep", {"$SLP"}, 300},
                    StopCase{"Dwell", "Run", {"G91F6000", "G4P60", "G1X5", "G1X5"}, 300}),
    [](const auto& each) { return std::string{each.param.name}; });

/// An idle report may have been sent before the first line.
TEST(SenderStopAtOnce, DoesNotCutAMotionOffThatHasJustBegun) {
  StopBench bench{{"G91F3000", "G1X100", "G1X100"}};
  ASSERT_LE(bench.until([&] { return bench.moves(); }), 60'000);
  bench.sender->abort();
  EXPECT_LE(bench.until([&] { return bench.sender->over(); }), 1'500);
  for (int ms = 0; ms < 50; ++ms) bench.turn();
  EXPECT_EQ(bench.controller.machine().state(), cnc::MachineState::kIdle)
      << "held first: no alarm, the position is known";
}

/// A machine that never stops is reset in any case.
TEST(SenderStopAtOnce, ResetsAControllerThatDoesNotObey) {
  Sender sender{{{.text = "G1X1", .number = 1}}, {}, milliseconds{0}};
  std::string sent;
  const auto take = [&] {
    while (!sender.output().empty()) {
      sent += sender.output();
      sender.wrote(sender.output().size());
    }
  };
  milliseconds now{0};
  sender.receive("Grbl 1.1h\r\n[OPT:V,15,128]\r\nok\r\nok\r\n", now);
  for (; now < milliseconds{100}; ++now) sender.attend(now);
  sender.abort();
  for (; !sender.over() && now < milliseconds{30'000}; ++now) {
    take();
    if (now.count() % 50 == 0) sender.receive("<Run|MPos:0,0,0|FS:100,0>\r\n", now);
    sender.attend(now);
  }
  take();
  EXPECT_NE(sent.find('\x18'), std::string::npos);
  EXPECT_LT(now, milliseconds{13'000});
}

}  // namespace
}  // namespace sim
