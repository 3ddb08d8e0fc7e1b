#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/application.hpp"
#include "hal/host/memory_store.hpp"
#include "hal/host/recording_port.hpp"

namespace cnc {

/// A serial line in memory.
class MemoryLink final : public hal::ByteStream {
 public:
  std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), incoming.size());
    for (std::size_t i = 0; i < count; ++i) into[i] = static_cast<std::byte>(incoming[i]);
    incoming.erase(0, count);
    return count;
  }
  std::size_t write(std::span<const std::byte> from) override {
    const std::size_t count = std::min(from.size(), room);
    for (const std::byte byte : from.first(count)) outgoing.push_back(static_cast<char>(byte));
    room -= count;
    return count;
  }

  bool may_wait() const override { return waits; }

  bool waits = true;  ///< If false, unread bytes may not wait, as on a serial line.
  std::string incoming;
  std::string outgoing;
  std::size_t room = ~std::size_t{0};  ///< Bytes that can be queued before the test fetches some.
};

/// Store in memory that calls `watcher` before each save.
class WatchedStore final : public hal::host::MemoryStore {
 public:
  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override {
    ++saves;
    if (watcher) watcher();
    return MemoryStore::save(number, record);
  }

  std::function<void()> watcher;
  int saves = 0;
};

/// The state of the pins after an interrupt.
struct Sight {
  std::uint64_t tick;
  std::array<std::int32_t, 6> position;
  std::uint16_t power;
  std::uint8_t digital;
  bool spindle;
};

/// The complete controller on recording pins. The fixture advances the time: in each millisecond it
/// runs a cycle of the main loop, then the interrupts that are due.
class ControllerTest : public testing::Test {
 protected:
  static constexpr std::uint64_t kTicksPerMillisecond = motion::kTicksPerSecond / 1000;

  /// Tests begin after the banner. As no sender polls here, the watchdog of the link ($858) is off.
  ControllerTest() {
    EXPECT_TRUE(machine.change_setting(setting::kLinkWatchdog, 0.0F).ok());
    store.watcher = [this] {
      EXPECT_FALSE(port.timer_started || next_ != kNoInterrupt || port.power != 0)
          << "stored while segments are queued or the output is on";
    };
    application.poll(hal::TickCount{0});
    link.outgoing.clear();
  }

  void run(int milliseconds) {
    for (; milliseconds > 0; --milliseconds) {
      application.poll(hal::TickCount{static_cast<std::uint32_t>(now / 4)});
      run_interrupts(now + kTicksPerMillisecond);
    }
  }
  /// Runs until the machine is idle, but at most for a minute.
  void run_until_idle() {
    int left = 60'000;
    do {
      run(1);
    } while (--left > 0 && !(machine.idle() && link.incoming.empty()));
    EXPECT_GT(left, 0) << "still busy after a minute";
  }

  /// Sends a line and runs until it is answered; returns the answer.
  std::string send(std::string_view line) {
    const std::size_t before = answers().size();
    link.incoming.append(line).append("\n");
    for (int left = 60'000; left > 0 && answers().size() == before; --left) run(1);
    const std::vector<std::string> all = answers();
    return all.size() > before ? all.back() : "no answer";
  }
  void send_all(const std::vector<std::string_view>& lines) {
    for (const std::string_view line : lines) EXPECT_EQ(send(line), "ok") << line;
  }
  /// Sends lines without waiting.
  void stream(std::string_view lines) { link.incoming.append(lines); }

  /// Returns the report that answers one request.
  std::string report(std::string_view request = "?") {
    link.outgoing.clear();
    stream(request);
    run(1);
    const auto lines = printed();
    return lines.empty() ? "nothing" : lines.front();
  }

  /// Returns the acknowledgements so far, without the messages before them.
  [[nodiscard]] std::vector<std::string> answers() const {
    std::vector<std::string> found;
    for (const std::string& line : printed()) {
      if (line == "ok" || line.rfind("error:", 0) == 0) found.push_back(line);
    }
    return found;
  }
  [[nodiscard]] std::vector<std::string> printed() const {
    std::vector<std::string> lines;
    std::size_t start = 0;
    for (std::size_t end = 0; (end = link.outgoing.find("\r\n", start)) != std::string::npos;) {
      lines.push_back(link.outgoing.substr(start, end - start));
      start = end + 2;
    }
    if (start < link.outgoing.size()) lines.push_back(link.outgoing.substr(start));
    return lines;
  }

  [[nodiscard]] double x_mm() const { return port.position[0] / 250.0; }
  [[nodiscard]] double seconds() const { return static_cast<double>(now) / 4.0e6; }
  [[nodiscard]] Coordinate at(Axis axis) const {
    return machine.interpreter().position()[index_of(axis)];
  }

  hal::host::RecordingPort port;
  WatchedStore store;
  MemoryLink link;
  Application<hal::host::RecordingPort> application{port, port, port, store, link};
  Machine& machine{application.machine()};
  std::uint64_t now = 0;
  std::vector<Sight> sights;  ///< The state of the pins after each interrupt that changed
                              ///< something.
  std::function<bool(const std::array<std::int32_t, 6>&)> plate;  ///< Returns whether the probe
                                                                  ///< touches at this position.

 private:
  static constexpr std::uint64_t kNoInterrupt = ~std::uint64_t{0};

  void run_interrupts(std::uint64_t end) {
    for (;;) {
      if (port.timer_started) {
        port.timer_started = false;
        next_ = now;
      }
      if (next_ >= end) break;
      now = next_;
      const std::uint32_t wait = application.on_step_interrupt();
      next_ = wait == 0 ? kNoInterrupt : now + wait;
      if (plate) port.probe = plate(port.position);
      look();
    }
    now = end;
  }

  void look() {
    const Sight sight{now, port.position, port.power, port.digital, port.spindle_enabled};
    const bool same = !sights.empty() && sights.back().position == sight.position &&
                      sights.back().power == sight.power &&
                      sights.back().digital == sight.digital &&
                      sights.back().spindle == sight.spindle;
    if (!same) sights.push_back(sight);
  }

  std::uint64_t next_ = kNoInterrupt;
};

}  // namespace cnc
