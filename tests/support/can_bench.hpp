#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/link/can/can_link.hpp"
#include "hal/host/can_bus.hpp"
#include "host-sim/can/can_host.hpp"
#include "host-sim/machine/virtual_controller.hpp"

namespace proof {

inline constexpr std::uint64_t kMillisecondNs = 1'000'000;  ///< Length of a millisecond, ns.

/// Records all edges of steps and beam from the first one on.
class EdgeRows final : public sim::TraceSink {
 public:
  void on_row(const sim::TraceRow& row) override {
    if (row.position != last_.position) moved_ns = row.time_ns;
    if (row.duty > 0.0F || last_.duty > 0.0F) lit_ns = row.time_ns;
    last_ = row;
    rows.push_back(row);
  }
  [[nodiscard]] bool lit() const { return last_.duty > 0.0F; }

  std::vector<sim::TraceRow> rows;
  std::uint64_t moved_ns = 0;  ///< Time of the last step, ns.
  std::uint64_t lit_ns = 0;    ///< Last time at which the beam was on, ns.

 private:
  sim::TraceRow last_{};
};

/// A controller on a bus, connected as in its main file.
struct BusStation {
  BusStation(hal::host::CanBus& bus, std::uint8_t node)
      : place{bus.join()}, link{place, node}, controller{link, {}} {
    controller.add_sink(edges);
    EXPECT_TRUE(machine().change_setting(cnc::setting::kCanNode, node).ok());
    // The link watchdog is off, because the senders of these tests do not poll.
    EXPECT_TRUE(machine().change_setting(cnc::setting::kLinkWatchdog, 0.0F).ok());
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
  EdgeRows edges;
  std::uint32_t session = 0;
};

/// A sender that streams a program by counting characters.
struct BusSender {
  BusSender(hal::host::CanBus& bus, std::uint8_t node) : place{bus.join()}, host{place, node} {}

  void turn(std::uint64_t now_ns) {
    if (!silent) host.attend(hal::TickCount{static_cast<std::uint32_t>(now_ns / 1000)});
    hear();
    while (next < lines.size()) {
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
  bool silent = false;
};

/// One bus with some controllers and a sender for each of them.
struct CanBench {
  static constexpr int kLooks = 10;  ///< Number of times per millisecond that senders and bus run.

  void turn() {
    for (int look = 0; look < kLooks; ++look) {
      now_ns += kMillisecondNs / kLooks;
      for (const auto& sender : senders) sender->turn(now_ns);
      bus.advance_to(now_ns);
    }
    for (const auto& station : stations) station->turn();
  }
  void turns(int count) {
    while (count-- > 0) turn();
  }
  void add(std::uint8_t node) {
    stations.push_back(std::make_unique<BusStation>(bus, node));
    senders.push_back(std::make_unique<BusSender>(bus, node));
    EXPECT_TRUE(senders.back()->host.order(cnc::can::NetworkCommand::kStart));
    turns(20);
  }
  /// Runs until every line is acknowledged and every motion has ended. @param most limit of the
  /// time, milliseconds
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
  [[nodiscard]] BusStation& station(std::size_t n = 0) { return *stations[n]; }
  [[nodiscard]] BusSender& sender(std::size_t n = 0) { return *senders[n]; }
  void begin_laser_line(std::size_t n = 0) {
    sender(n).lines = {"$32=1", "G91 M4 S500 F6000", "G1 X200"};
    turns(500);
    ASSERT_TRUE(station(n).edges.lit());
    ASSERT_EQ(station(n).machine().state(), cnc::MachineState::kRun);
  }
  /// Expects that the last step and the last light came before or at `time_ns`.
  void expect_dark_since(std::uint64_t time_ns, std::size_t n = 0) {
    station(n).controller.end();
    EXPECT_FALSE(station(n).edges.lit());
    EXPECT_LE(station(n).edges.lit_ns, time_ns);
    EXPECT_LE(station(n).edges.moved_ns, time_ns);
  }

  hal::host::CanBus bus{1'000'000, 1};
  std::uint64_t now_ns = 0;
  std::vector<std::unique_ptr<BusStation>> stations;
  std::vector<std::unique_ptr<BusSender>> senders;
};

}  // namespace proof
