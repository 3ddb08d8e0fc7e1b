#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "firmware/steps/step_generator.hpp"
#include "hal/interface/step_port.hpp"
#include "tests/support/let_in.hpp"

namespace cnc {

/// One call of the step interrupt to its port.
struct Edge {
  enum class Kind { kDirection, kRaise, kLower, kPower, kOutputs, kAnalog };

  std::uint64_t tick;
  Kind kind;
  std::uint32_t value;  ///< Mask, duty or channel, by the kind of the edge.
};

/// Records every edge with its time, and simulates switches and a probe plate.
class EdgePort {
 public:
  void set_direction(hal::AxisMask negative) noexcept {
    log(Edge::Kind::kDirection, negative.bits);
    negative_ = negative.bits;
  }
  void raise_steps(hal::AxisMask axes, hal::AxisMask second) noexcept {
    log(Edge::Kind::kRaise, axes.bits);
    for (unsigned axis = 0; axis < kAxisCount; ++axis) {
      const std::int32_t step = (negative_ >> axis & 1U) != 0 ? -1 : 1;
      if ((axes.bits >> axis & 1U) != 0) position[axis] += step;
      if ((second.bits >> axis & 1U) != 0) second_position[axis] += step;
    }
  }
  void lower_steps() noexcept { log(Edge::Kind::kLower, 0); }
  void set_power(std::uint16_t duty) noexcept {
    log(Edge::Kind::kPower, duty);
    power = duty;
  }
  void change_outputs(std::uint8_t raise, std::uint8_t lower) noexcept {
    log(Edge::Kind::kOutputs, raise);
    digital = static_cast<std::uint8_t>((digital | raise) & ~lower);
  }
  void set_analog(std::uint8_t channel, std::uint16_t value) noexcept {
    log(Edge::Kind::kAnalog, channel);
    analog = value;
  }
  void start_timer() noexcept { started = true; }
  [[nodiscard]] hal::SwitchMask switches() const noexcept {
    return {.first = static_cast<std::uint8_t>(position[0] >= switch_from ? 1 : 0),
            .second = static_cast<std::uint8_t>(second_position[0] >= second_switch_from ? 1 : 0)};
  }
  [[nodiscard]] bool probe_contact() noexcept { return position[0] >= contact_from; }

  [[nodiscard]] std::vector<Edge> of_kind(Edge::Kind kind) const {
    std::vector<Edge> found;
    for (const Edge& edge : edges) {
      if (edge.kind == kind) found.push_back(edge);
    }
    return found;
  }

  std::uint64_t now = 0;
  std::vector<Edge> edges;
  AxisArray<std::int32_t> position{};
  AxisArray<std::int32_t> second_position{};
  std::int32_t switch_from = 1'000'000'000;  ///< X step from which on the X switch is closed.
  std::int32_t second_switch_from = 1'000'000'000;
  std::int32_t contact_from = 1'000'000'000;  ///< X step from which on the probe touches.
  std::uint16_t power = 0;
  std::uint16_t analog = 0;
  std::uint8_t digital = 0;
  bool started = false;

 private:
  void log(Edge::Kind kind, std::uint32_t value) { edges.push_back({now, kind, value}); }
  std::uint8_t negative_ = 0;
};
static_assert(hal::StepPort<EdgePort>);

/// A step generator with a timer that the test drives.
class StepGeneratorTest : public testing::Test {
 protected:
  using Kind = Edge::Kind;

  /// Runs interrupts until the timer is stopped, or `ticks` ticks have passed.
  void run(std::uint64_t ticks = 1'000'000'000) {
    let_in(generator);
    if (port.started) next_ = port.now;
    port.started = false;
    const std::uint64_t end = port.now + ticks;
    while (next_ != kNoInterrupt && next_ < end) {
      port.now = next_;
      const std::uint32_t wait = generator.player().on_interrupt();
      next_ = wait == 0 ? kNoInterrupt : next_ + wait;
    }
    if (next_ != kNoInterrupt) port.now = end;
    let_in(generator);
  }

  /// Returns a segment with `count` steps of one axis, evenly distributed over `ticks`.
  static motion::Segment even(std::uint32_t ticks, std::uint16_t count, std::size_t axis = 0) {
    motion::Segment segment{.ticks = ticks};
    const std::int32_t interval = static_cast<std::int32_t>(ticks << 16) / count;
    segment.trains[axis] = {.first_q16 = interval / 2, .interval_q16 = interval, .count = count};
    return segment;
  }
  static motion::Segment last(motion::Segment segment) {
    segment.comes_to_rest = true;
    return segment;
  }

  EdgePort port;
  StepGenerator<EdgePort, 64> generator{port};

 private:
  static constexpr std::uint64_t kNoInterrupt = ~std::uint64_t{0};
  std::uint64_t next_ = kNoInterrupt;
};

}  // namespace cnc
