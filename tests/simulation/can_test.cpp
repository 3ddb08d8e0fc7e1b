#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "firmware/link/can/can_link.hpp"
#include "hal/host/can_bus.hpp"
#include "host-sim/can/can_host.hpp"
#include "host-sim/machine/virtual_controller.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

namespace can = cnc::can;
using can::NetworkCommand;
constexpr std::uint64_t kMs = 1'000'000;

/// Steps and beam, from the first edge on.
class Edges final : public sim::TraceSink {
 public:
  void on_row(const sim::TraceRow& row) override {
    if (row.position != last_.position) moved_ns = row.time_ns;
    if (row.duty > 0.0F || last_.duty > 0.0F) lit_ns = row.time_ns;
    last_ = row;
    rows.push_back(row);
  }
  [[nodiscard]] bool lit() const { return last_.duty > 0.0F; }

  std::vector<sim::TraceRow> rows;
  std::uint64_t moved_ns = 0;  ///< The last step.
  std::uint64_t lit_ns = 0;    ///< The last time that there was light.

 private:
  sim::TraceRow last_{};
};

/// A controller on a bus, as its main file has it.
struct Station {
  Station(hal::host::CanBus& bus, std::uint8_t node)
      : place{bus.join()}, link{place, node}, controller{link, {}} {
    controller.add_sink(edges);
  }

  void turn() {
    const hal::TickCount now{static_cast<std::uint32_t>(controller.now_ticks() / 4)};
    controller.firmware().attend(link, now);
    if (link.session() != session) {
      session = link.session();
      if (session != 0) {
        controller.firmware().begin_sender();
      } else {
        controller.firmware().lose_sender();
      }
    }
    controller.turn();
  }
  [[nodiscard]] cnc::Machine& machine() { return controller.machine(); }

  hal::host::CanBus::Node& place;
  cnc::CanLink link;
  sim::VirtualController controller;
  Edges edges;
  std::uint32_t session = 0;
};

/// Somebody who streams a program by counting characters.
struct Sender {
  Sender(hal::host::CanBus& bus, std::uint8_t node) : place{bus.join()}, host{place, node} {}

  void turn(std::uint64_t now_ns) {
    if (!silent) host.attend(hal::TickCount{static_cast<std::uint32_t>(now_ns / 1000)});
    hear();
    while (streams && next < lines.size()) {
      const std::string line = lines[next] + "\n";
      if (in_flight + line.size() > 1000) return;
      const std::string_view rest = std::string_view{line}.substr(part);
      part += host.write(std::as_bytes(std::span{rest}));
      if (part < line.size()) return;
      part = 0;
      ++next;
      in_flight += line.size();
      sizes.push_back(line.size());
    }
  }
  void hear() {
    std::array<char, 256> text{};
    for (;;) {
      const std::size_t count = host.read(std::as_writable_bytes(std::span{text}));
      if (count == 0) return;
      for (const char letter : std::string_view{text.data(), count}) {
        if (letter != '\n') {
          heard += letter;
          continue;
        }
        if (heard == "ok\r" || heard.starts_with("error:")) answered();
        if (heard.starts_with("error:")) errors.push_back(heard);
        heard.clear();
      }
    }
  }
  void answered() {
    ASSERT_LT(oks, sizes.size());
    in_flight -= sizes[oks++];
  }
  [[nodiscard]] bool done() const { return oks == lines.size(); }
  void act(std::string_view bytes) { EXPECT_TRUE(host.act(std::as_bytes(std::span{bytes}))); }

  hal::host::CanBus::Node& place;
  sim::CanHost host;
  std::vector<std::string> lines;
  std::vector<std::string> errors;
  std::vector<std::size_t> sizes;
  std::string heard;
  std::size_t next = 0;
  std::size_t part = 0;
  std::size_t oks = 0;
  std::size_t in_flight = 0;
  bool streams = true;
  bool silent = false;
};

/// A laser's job of short lines and arcs, whose beginning waits in a hold until all of it is known
/// that the look-ahead can hold.
std::vector<std::string> job(std::size_t lines) {
  std::vector<std::string> text{"G21 G91 M4 S500 F3000"};
  Random random{7};
  for (std::size_t n = 0; n < lines; ++n) {
    char line[64];
    if (n % 5 == 4) {
      std::snprintf(line, sizeof line, "G2 X%.3f I%.3f", 1.0, 0.5);
    } else {
      std::snprintf(line, sizeof line, "G1 X%.3f Y%.3f", random.between(-0.4, 0.8), random.between(-0.5, 0.5));
    }
    text.emplace_back(line);
  }
  return text;
}

/// One bus, controllers on it, and a sender for each.
struct CanBench {
  static constexpr int kLooks = 10;  ///< A millisecond, of senders.

  void turn() {
    for (int look = 0; look < kLooks; ++look) {
      now_ns += kMs / kLooks;
      for (const auto& sender : senders) sender->turn(now_ns);
      bus.advance_to(now_ns);
    }
    for (const auto& station : stations) station->turn();
  }
  void turns(int count) {
    while (count-- > 0) turn();
  }
  void add(std::uint8_t node) {
    stations.push_back(std::make_unique<Station>(bus, node));
    senders.push_back(std::make_unique<Sender>(bus, node));
    EXPECT_TRUE(senders.back()->host.order(NetworkCommand::kStart));
    turns(20);
  }
  /// Until all is said, heard and driven. @param most milliseconds
  void finish(int most = 600'000) {
    const auto done = [this] {
      for (std::size_t n = 0; n < senders.size(); ++n) {
        if (!senders[n]->done() || !stations[n]->machine().idle()) return false;
      }
      return true;
    };
    while (most > 0 && !done()) {
      turn();
      --most;
    }
    EXPECT_GT(most, 0) << senders[0]->oks << " of " << senders[0]->lines.size();
    turns(20);
  }
  [[nodiscard]] Station& station(std::size_t n = 0) { return *stations[n]; }
  [[nodiscard]] Sender& sender(std::size_t n = 0) { return *senders[n]; }
  void begin_laser_line(std::size_t n = 0) {
    sender(n).lines = {"$32=1", "G91 M4 S500 F6000", "G1 X200"};
    turns(500);
    ASSERT_TRUE(station(n).edges.lit());
    ASSERT_EQ(station(n).machine().state(), cnc::MachineState::kRun);
  }
  /// Motion and light have ended by then.
  void expect_dark_since(std::uint64_t time_ns, std::size_t n = 0) {
    station(n).controller.end();
    EXPECT_FALSE(station(n).edges.lit());
    EXPECT_LE(station(n).edges.lit_ns, time_ns);
    EXPECT_LE(station(n).edges.moved_ns, time_ns);
  }

  hal::host::CanBus bus{1'000'000, 1};
  std::uint64_t now_ns = 0;
  std::vector<std::unique_ptr<Station>> stations;
  std::vector<std::unique_ptr<Sender>> senders;
};

class CanTest : public testing::Test, public CanBench {};

TEST_F(CanTest, AJobIsDrivenAsOverAnyLink) {
  add(0x11);
  sender().lines = {"$32=1", "G91 G1 X10 F6000", "G1 Y5", "G2 X4 I2", "bad"};
  finish();
  EXPECT_EQ(sender().errors.size(), 1U);
  EXPECT_EQ(station().machine().position()[0].nanometres(), 14'000'000);
  EXPECT_EQ(station().machine().position()[1].nanometres(), 5'000'000);
  turns(600);
  EXPECT_EQ(sender().host.state(), cnc::can::NodeState::kOperational);
}

TEST_F(CanTest, RealtimeBytesActWhateverTheTextIsInTheMiddleOf) {
  add(0x11);
  sender().lines = {"G91 G1 X100 F600"};
  turns(300);
  const std::string_view unfinished = "G1 X1 (a comment, and in it";
  EXPECT_EQ(sender().host.write(std::as_bytes(std::span{unfinished})), unfinished.size());
  turns(20);
  ASSERT_EQ(station().machine().state(), cnc::MachineState::kRun);
  sender().act("!");
  turns(300);
  EXPECT_EQ(station().machine().state(), cnc::MachineState::kHold);
}

TEST_F(CanTest, AnEmergencyStopEndsLightAndMotionOfAllWithinAMillisecondAndAFrame) {
  for (const std::uint32_t id : {can::kNetwork, can::kFailSafe}) {
    SCOPED_TRACE(id);
    stations.clear();
    senders.clear();
    add(0x11);
    add(0x12);
    begin_laser_line(0);
    begin_laser_line(1);
    const std::array stop{std::byte{0x02}, std::byte{0x00}};
    ASSERT_TRUE(sender().place.send(hal::can_frame(id, stop)));
    const std::uint64_t said_ns = now_ns;
    turns(100);
    for (std::size_t n = 0; n < 2; ++n) {
      // The frame passes in the millisecond after this one, and the turn after that acts.
      expect_dark_since(said_ns + 2 * kMs, n);
      EXPECT_EQ(station(n).machine().alarm(), cnc::Alarm::kEmergencyStop);
      ASSERT_FALSE(sender(n).host.emergencies().empty());
      EXPECT_EQ(sender(n).host.emergencies().back().alarm, 24);
    }
  }
}

TEST_F(CanTest, AHostThatFallsSilentEndsLightAndMotionWithin100Milliseconds) {
  const std::vector<std::pair<const char*, std::function<void()>>> ways{
      {"the host is silent", [this] { sender().silent = true; }},
      {"its wire is pulled", [this] { sender().place.plug(false); }},
      {"the controller's wire is pulled", [this] { station().place.plug(false); }},
      {"every frame is disturbed", [this] { bus.disturb(1.0); }}};
  for (const auto& [name, fail] : ways) {
    SCOPED_TRACE(name);
    bus.disturb(0.0);
    stations.clear();
    senders.clear();
    add(0x11);
    begin_laser_line();
    fail();
    const std::uint64_t silent_ns = now_ns;
    turns(400);
    station().controller.end();
    EXPECT_LE(station().edges.lit_ns, silent_ns + 100 * kMs);
    EXPECT_FALSE(station().edges.lit());
    EXPECT_EQ(station().machine().state(), cnc::MachineState::kDoor);
    EXPECT_EQ(station().machine().alarm(), cnc::Alarm::kNone) << "the place stays known";
  }
}

TEST_F(CanTest, TwoControllersOnABusDriveTwoJobsAtOnce) {
  add(0x11);
  add(0x12);
  for (std::size_t n = 0; n < 2; ++n) {
    sender(n).lines = {"$32=1", "G91 M4 S500 F6000"};
    for (int line = 0; line < 300; ++line) {
      sender(n).lines.emplace_back(n == 0 ? "G1 X0.2 Y0.1" : "G1 X-0.1 Y0.3");
    }
  }
  finish();
  const auto nm = [this](std::size_t n, std::size_t axis) {
    return station(n).machine().position()[axis].nanometres();
  };
  EXPECT_EQ(nm(0, 0), 60'000'000);
  EXPECT_EQ(nm(0, 1), 30'000'000);
  EXPECT_EQ(nm(1, 0), -30'000'000);
  EXPECT_EQ(nm(1, 1), 90'000'000);
}

/// What ISO 15765-2 allows: messages as long as the controller takes them, each with its flow
/// control, back to back, and an answer for each line.
double possible_bytes_per_second(std::string_view line) {
  const auto bits_of = [](std::uint32_t id, std::string_view payload) {
    return hal::host::can_bits(hal::can_frame(id, std::as_bytes(std::span{payload})));
  };
  constexpr double kMessage = cnc::IsoTpReceiver::kLongest;
  const double frames = 1.0 + std::ceil((kMessage - 6.0) / 7.0);
  const double answers = kMessage / static_cast<double>(line.size() + 1);
  const double bits = frames * bits_of(can::kTextTo + 0x11, line.substr(0, 8)) +
                      bits_of(can::kTextFrom + 0x11, "0  ") +
                      answers * bits_of(can::kTextFrom + 0x11, "\4ok\r\n");
  return 1e6 * kMessage / bits;
}

TEST_F(CanTest, TextPassesAsFastAsTheBusAllows) {
  add(0x11);
  const std::string line = "(0123456789 0123456789 0123456789 0123456789 0123456789 012)";
  sender().lines.assign(2000, line);
  const std::uint64_t begun_ns = now_ns;
  while (!sender().done() && now_ns < 10'000 * kMs) turn();
  const double seconds = static_cast<double>(now_ns - begun_ns) * 1e-9;
  const double found = 2000.0 * static_cast<double>(line.size() + 1) / seconds;
  const double possible = possible_bytes_per_second(line);
  std::printf("%.0f bytes/s of text, of %.0f possible\n", found, possible);
  EXPECT_GT(found, 0.9 * possible);
}

/// Edges from this time on, counted from the first; a sender's delays shift all of it.
std::vector<sim::TraceRow> edges_from(std::uint64_t time_ns, std::vector<sim::TraceRow> rows) {
  std::erase_if(rows, [&](const sim::TraceRow& row) { return row.time_ns < time_ns; });
  const std::uint64_t begin_ns = rows.empty() ? 0 : rows.front().time_ns;
  for (sim::TraceRow& row : rows) row.time_ns -= begin_ns;
  return rows;
}

bool same(const sim::TraceRow& a, const sim::TraceRow& b) {
  return a.time_ns == b.time_ns && a.position == b.position && a.duty == b.duty;
}

/// The planner has all that it can hold before motion begins: then nothing depends on when a line
/// arrives, as long as lines come faster than they are driven.
class DisturbedBus : public testing::TestWithParam<int> {
 protected:
  static std::vector<sim::TraceRow> drive(CanBench& bench, double share) {
    bench.bus.disturb(share);
    bench.add(0x11);
    bench.sender().lines = job(1500);
    bench.sender().lines.insert(bench.sender().lines.begin(), {"$32=1", "G1 X0.1 F60"});
    const auto state = [&] { return bench.station().machine().state(); };
    for (int n = 0; n < 1000 && state() != cnc::MachineState::kRun; ++n) bench.turn();
    bench.sender().act("!");
    bench.turns(3000);
    EXPECT_EQ(state(), cnc::MachineState::kHold);
    bench.sender().act("~");
    const std::uint64_t begun_ns = bench.now_ns;
    bench.finish();
    EXPECT_TRUE(bench.sender().errors.empty());
    EXPECT_EQ(bench.station().machine().alarm(), cnc::Alarm::kNone);
    return edges_from(begun_ns, bench.station().edges.rows);
  }
};

TEST_P(DisturbedBus, DrivesTheSameStepsAtTheSameTimes) {
  CanBench quiet;
  const std::vector<sim::TraceRow> wanted = drive(quiet, 0.0);
  CanBench noisy;
  const std::vector<sim::TraceRow> found = drive(noisy, GetParam() / 100.0);
  const hal::CanHealth health = noisy.station().place.health();
  std::printf("%d %% disturbed: %llu frames passed, %llu did not, bus-off %u and %u times; %zu edges\n",
              GetParam(),
              static_cast<unsigned long long>(noisy.bus.frames()),
              static_cast<unsigned long long>(noisy.bus.disturbed()),
              health.bus_offs,
              noisy.sender().place.health().bus_offs,
              found.size());
  EXPECT_GT(wanted.size(), 10'000U);
  ASSERT_EQ(found.size(), wanted.size());
  const auto [a, b] = std::mismatch(found.begin(), found.end(), wanted.begin(), same);
  EXPECT_TRUE(a == found.end()) << "at " << a->time_ns << " instead of " << b->time_ns;
}

INSTANTIATE_TEST_SUITE_P(Shares, DisturbedBus, testing::Values(0, 5, 10, 30));

}  // namespace
}  // namespace proof
