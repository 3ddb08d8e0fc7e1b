#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/can_bench.hpp"

namespace proof {
namespace {

namespace can = cnc::can;

class CanTest : public testing::Test, public CanBench {};

TEST_F(CanTest, AJobIsDrivenAsOverAnyLink) {
  add(0x11);
  sender().lines = {"$32=1", "G91 G1 X10 F6000", "G1 Y5", "G2 X4 I2", "bad"};
  finish();
  EXPECT_EQ(sender().errors.size(), 1U);
  EXPECT_EQ(station().machine().motion().tool_place()[0].nanometres(), 14'000'000);
  EXPECT_EQ(station().machine().motion().tool_place()[1].nanometres(), 5'000'000);
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
      // The frame takes up to the next cycle, and the cycle after it acts.
      expect_dark_since(said_ns + 2 * kMillisecondNs, n);
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
    EXPECT_LE(station().edges.lit_ns, silent_ns + 100 * kMillisecondNs);
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
    return station(n).machine().motion().tool_place()[axis].nanometres();
  };
  EXPECT_EQ(nm(0, 0), 60'000'000);
  EXPECT_EQ(nm(0, 1), 30'000'000);
  EXPECT_EQ(nm(1, 0), -30'000'000);
  EXPECT_EQ(nm(1, 1), 90'000'000);
}

/// Returns the greatest rate that ISO 15765-2 allows, bytes per second: messages of the greatest
/// length that the controller accepts, each with its flow control, back to back, and an answer for
/// each line.
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
  while (!sender().done() && now_ns < 10'000 * kMillisecondNs) turn();
  const double seconds = static_cast<double>(now_ns - begun_ns) * 1e-9;
  const double found = 2000.0 * static_cast<double>(line.size() + 1) / seconds;
  const double possible = possible_bytes_per_second(line);
  std::printf("%.0f bytes/s of text, of %.0f possible\n", found, possible);
  EXPECT_GT(found, 0.9 * possible);
}

/// At 100 mm/s a pixel of 0.1 mm lasts a millisecond.
TEST_F(CanTest, ARasterIsDrivenAtSpeed) {
  constexpr std::size_t kPixels = 5000;
  add(0x11);
  for (const auto& [number, value] : {std::pair{32, 1.0F}, {110, 30'000.0F}, {120, 1.0e6F}}) {
    const auto setting = static_cast<std::uint16_t>(number);
    ASSERT_TRUE(station().machine().change_setting(setting, value).ok());
  }
  sender().lines = {"G91G1F6000M4"};
  for (std::size_t i = 0; i < kPixels; ++i) {
    sender().lines.push_back("X.1S" + std::to_string(100 + i * 37 % 900));
  }
  finish(20'000);
  const EdgeRows& edges = station().edges;
  ASSERT_FALSE(edges.rows.empty());
  const double seconds = 1e-9 * static_cast<double>(edges.moved_ns - edges.rows.front().time_ns);
  const double pixels = static_cast<double>(kPixels) * 1e-3;
  std::printf("%.3f s for %.3f s of pixels\n", seconds, pixels);
  EXPECT_EQ(sender().errors.size(), 0U);
  EXPECT_GT(seconds, 0.999 * pixels);
  EXPECT_LT(seconds, 1.005 * pixels);
}

}  // namespace
}  // namespace proof
