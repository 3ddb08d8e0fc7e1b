#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "hal/interface/step_port.hpp"
#include "planner/base/axes.hpp"

namespace cnc {

/// State of the limit switches during homing: the position at which each axis found its switch, and
/// the motors that wait at their switches for the other motor.
///
/// A switch counts as found from its first contact on, so its bounce has no effect.
class SwitchWatch {
 public:
  // Functions for the main loop while the interrupt does not run.

  void add(std::uint8_t axes, std::uint8_t squared) {
    const auto others = static_cast<std::uint8_t>(~axes);
    gates_.first = static_cast<std::uint8_t>(gates_.first & others);
    gates_.second = static_cast<std::uint8_t>(gates_.second & others);
    squared_ = static_cast<std::uint8_t>((squared_ & others) | (squared & axes));
    found_.store(static_cast<std::uint8_t>(found_.load() & others));
    watched_.store(static_cast<std::uint8_t>(watched_.load() | axes), std::memory_order_release);
  }
  void clear() {
    gates_ = {};
    found_.store(0);
    watched_.store(0, std::memory_order_release);
  }

  // Functions for the main loop at any time.

  [[nodiscard]] std::uint8_t found() const { return found_.load(std::memory_order_acquire); }
  [[nodiscard]] std::int32_t position(std::size_t axis) const { return found_at_[axis]; }
  [[nodiscard]] std::int32_t skew(std::size_t axis) const {
    return found_at_[axis] - first_found_at_[axis];
  }

  // Functions for the step interrupt. At rest the main loop may call gates(), too.

  [[nodiscard]] bool active() const noexcept {
    return watched_.load(std::memory_order_relaxed) != 0;
  }
  /// Returns the motors that get no steps, because they wait at their switches.
  [[nodiscard]] const hal::SwitchMask& gates() const noexcept { return gates_; }

  /// Checks the switches; to be called after each step of any motor.
  void look(const hal::SwitchMask& closed, const AxisArray<std::int32_t>& position) noexcept {
    const std::uint8_t watched = watched_.load(std::memory_order_relaxed);
    const unsigned either = closed.first | closed.second | gates_.first | gates_.second;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if ((watched & either & (1U << axis)) != 0) look(axis, closed, position[axis]);
    }
  }

 private:
  void look(std::size_t axis, const hal::SwitchMask& closed, std::int32_t position) noexcept {
    const auto bit = static_cast<std::uint8_t>(1U << axis);
    const auto others = static_cast<std::uint8_t>(~bit);
    const bool waiting = ((gates_.first | gates_.second) & bit) != 0;
    if (!waiting) first_found_at_[axis] = position;
    if ((squared_ & bit) != 0) {
      gates_.first = static_cast<std::uint8_t>(gates_.first | (closed.first & bit));
      gates_.second = static_cast<std::uint8_t>(gates_.second | (closed.second & bit));
      if ((gates_.first & gates_.second & bit) == 0) return;
    }
    gates_.first = static_cast<std::uint8_t>(gates_.first & others);
    gates_.second = static_cast<std::uint8_t>(gates_.second & others);
    found_at_[axis] = position;
    watched_.store(static_cast<std::uint8_t>(watched_.load(std::memory_order_relaxed) & others),
                   std::memory_order_relaxed);
    found_.store(static_cast<std::uint8_t>(found_.load(std::memory_order_relaxed) | bit),
                 std::memory_order_release);
  }

  std::atomic<std::uint8_t> watched_{0};
  std::atomic<std::uint8_t> found_{0};
  std::uint8_t squared_ = 0;
  hal::SwitchMask gates_{};
  AxisArray<std::int32_t> found_at_{};
  AxisArray<std::int32_t> first_found_at_{};
};

}  // namespace cnc
