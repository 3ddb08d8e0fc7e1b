#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>

#include "firmware/link/link_choice.hpp"
#include "host-sim/machine/virtual_controller.hpp"
#include "tests/hal/stm32f405/usb/usb_desk.hpp"

namespace sim {
namespace {

using hal::stm32f405::bytes_in;
using hal::stm32f405::UsbDesk;
using Shake = UsbDesk::Shake;

class NoCable final : public hal::ByteStream {
 public:
  std::size_t read(std::span<std::byte>) override { return 0; }
  std::size_t write(std::span<const std::byte> from) override { return from.size(); }
  bool may_wait() const override { return false; }
};

/// A laser on the model of the chip's USB core, with a host that writes ahead as far as the device
/// permits.
class UsbMachine {
 public:
  UsbMachine() {
    EXPECT_TRUE(controller_.machine().change_setting(32, 1.0F).ok());
    EXPECT_TRUE(controller_.machine().change_setting(858, 0.0F).ok());
    EXPECT_TRUE(desk.ready());
    turns(20);
  }

  /// Runs one millisecond: the controller reads the bytes that arrived, and the host fetches the
  /// answers.
  void turn() {
    desk.begin_turn();
    switch (cables_.attend()) {
      case cnc::LinkChoice::Change::kCame:
        controller_.firmware().begin_sender();
        break;
      case cnc::LinkChoice::Change::kWent:
        controller_.firmware().lose_sender();
        break;
      case cnc::LinkChoice::Change::kNone:
        break;
    }
    controller_.turn();
    desk.serve();
    if (pulled_) return;
    while (const auto packet = desk.host.fetch()) said.append(packet->begin(), packet->end());
  }
  /// Pulls the cable: no host fetches data any more, and the bus becomes idle.
  void pull_cable() {
    pulled_ = true;
    desk.core.suspend();
    desk.serve();
  }
  void turns(int count) {
    for (; count > 0; --count) turn();
  }
  /// Sends a text in packets, each as soon as the device accepts it. Returns the duration, ms.
  int send(std::string_view text) {
    int waited = 0;
    for (; !text.empty(); text.remove_prefix(std::min<std::size_t>(64, text.size()))) {
      const auto packet = bytes_in(text.substr(0, 64));
      while (desk.host.send(packet) != Shake::kAck && waited < 60'000) {
        turn();
        ++waited;
      }
    }
    return waited;
  }
  /// Runs until `done` holds; returns the duration, ms.
  template <typename Done>
  int until(Done&& done) {
    int waited = 0;
    for (; !done() && waited < 60'000; ++waited) turn();
    return waited;
  }
  [[nodiscard]] bool lit() const { return controller_.port().power > 0; }
  [[nodiscard]] cnc::MachineState state() const { return controller_.machine().state(); }

  UsbDesk desk;
  std::string said;

 private:
  bool pulled_ = false;
  NoCable none_;
  cnc::LinkChoice cables_{desk.line, none_};
  VirtualController controller_{cables_, MachineModel{}};
};

/// Returns lines that keep the machine cutting for longer than the test lasts.
std::string cutting(std::size_t bytes) {
  std::string text = "G21 G90 M3 S500 F1200\n";
  while (text.size() < bytes) text += "G1 X250 Y100\nG1 X0 Y0\n";
  return text;
}

constexpr int kMaxMs = 20;

class UsbQueue : public testing::TestWithParam<std::size_t> {
 protected:
  UsbQueue() {
    machine.send(cutting(GetParam()));
    machine.until([this] { return machine.lit(); });
    machine.said.clear();
  }
  UsbMachine machine;
};

TEST_P(UsbQueue, HoldsReportsAndResetsAtOnce) {
  int worst = machine.send("?");
  worst += machine.until([this] { return machine.said.find("<Run") != std::string::npos; });
  int waited = machine.send("!");
  waited += machine.until([this] { return machine.state() == cnc::MachineState::kHold; });
  worst = std::max(worst, waited);
  waited = machine.send("\x18");
  waited += machine.until([this] { return !machine.lit(); });
  worst = std::max(worst, waited);
  std::printf("behind %zu bytes: %d ms at worst\n", GetParam(), worst);
  EXPECT_LE(worst, kMaxMs);
}

TEST_P(UsbQueue, NoticesAtOnceThatTheLineIsClosed) {
  ASSERT_TRUE(machine.desk.host.close());
  EXPECT_LE(machine.until([this] { return !machine.lit(); }), 2);
}

/// A bus without a host is idle, which the core reports after 3 ms (USB 2.0, 7.1.7.6).
TEST_P(UsbQueue, NoticesAtOnceThatTheCableIsPulled) {
  machine.pull_cable();
  EXPECT_LE(machine.until([this] { return !machine.lit(); }), 2);
}

INSTANTIATE_TEST_SUITE_P(AtAnyFill,
                         UsbQueue,
                         testing::Values(100, 1'000, 4'000, 4'096, 4'600, 5'000, 20'000, 200'000));

TEST(UsbQueueLimits, AfterAnOverrunNothingIsDrivenUntilAResetAndEveryLineHasItsAnswer) {
  UsbMachine machine;
  machine.said.clear();
  std::string lines = "G91 F60000\n";
  for (int line = 0; line < 2'000; ++line) lines += "G1 X1 Y1\n";
  machine.send(lines);
  machine.turns(20'000);
  const auto count = [&machine](std::string_view words) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = machine.said.find(words, at)) != std::string::npos; ++at)
      ++found;
    return found;
  };
  EXPECT_GT(count("error:11\r\n"), 100U);
  EXPECT_EQ(count("error:11\r\n") + count("ok\r\n"), 2'001U);
  EXPECT_NE(machine.said.find("more lines came than the buffer holds"), std::string::npos);
  const std::size_t first = machine.said.find("error:11");
  EXPECT_EQ(machine.said.find("ok\r\n", first), std::string::npos) << "none follows a gap";
  machine.said.clear();
  machine.send("G1 X1\n");
  machine.turns(100);
  EXPECT_EQ(count("error:11\r\n"), 1U);
  machine.send("\x18");
  machine.turns(100);
  machine.send("G4 P0\n");
  machine.turns(100);
  EXPECT_EQ(count("ok\r\n"), 1U);
}

}  // namespace
}  // namespace sim
