#pragma once

#include <gtest/gtest.h>

#include <string_view>
#include <utility>
#include <vector>

#include "host-sim/machine/virtual_controller.hpp"
#include "tests/support/silent_link.hpp"

namespace proof {

/// A machine in virtual time, to which a test sends lines as the protocol does.
class MachineBench {
 public:
  explicit MachineBench(const sim::MachineModel& model = {}) : controller{link_, model} {}

  void set(const std::vector<std::pair<int, double>>& values) {
    for (const auto& [number, value] : values) {
      EXPECT_TRUE(machine()
                      .change_setting(static_cast<std::uint16_t>(number), static_cast<float>(value))
                      .ok())
          << "$" << number << "=" << value;
    }
  }

  void run(int milliseconds) {
    while (milliseconds-- > 0) controller.turn();
  }
  /// Runs until all requested work is done; fails after ten minutes of machine time.
  void finish() {
    int left = 600'000;
    do {
      controller.turn();
    } while (--left > 0 && (machine().busy() || !machine().idle()));
    EXPECT_GT(left, 0) << "the machine hangs";
  }
  /// Sends a line as soon as the machine accepts one.
  void send(std::string_view line) {
    for (int left = 600'000; machine().busy() && left > 0; --left) controller.turn();
    ASSERT_FALSE(machine().busy()) << line;
    ASSERT_FALSE(machine().locked()) << line;
    const auto refusal = machine().accept(line);
    EXPECT_FALSE(refusal.has_value()) << line;
  }
  void home(std::uint8_t axes = 0) {
    run(5);
    ASSERT_EQ(machine().why_not_home(axes), cnc::HomingRefusal::kNone);
    machine().home(axes);
    finish();
  }

  [[nodiscard]] cnc::Machine& machine() { return controller.machine(); }
  [[nodiscard]] double mm(std::size_t axis) {
    return static_cast<double>(machine().motion().tool_place()[axis].nanometres()) * 1.0e-6;
  }
  [[nodiscard]] std::int32_t motor(std::size_t axis) const {
    return controller.port().position[axis];
  }

 private:
  SilentLink link_;

 public:
  sim::VirtualController controller;
};

}  // namespace proof
