#pragma once

#include <atomic>
#include <cstdint>

#include "planner/base/axes.hpp"

namespace cnc {

/// Latches the positions of the motors at the first step after which the probe input reads the
/// level that arm() has set.
class ProbeLatch {
 public:
  // Functions for the main loop.

  /// Begins to wait until the probe input reads `contact`. Forgets an earlier hit.
  /// @pre the step interrupt does not run
  void arm(bool contact) {
    contact_ = contact;
    hit_.store(false);
    armed_.store(true, std::memory_order_relaxed);
  }
  void disarm() { armed_.store(false, std::memory_order_relaxed); }
  /// Returns the latched positions, in steps. @pre hit()
  [[nodiscard]] const AxisArray<std::int32_t>& position() const { return position_; }

  // Functions for any context.

  [[nodiscard]] bool armed() const noexcept { return armed_.load(std::memory_order_relaxed); }
  [[nodiscard]] bool hit() const noexcept { return hit_.load(std::memory_order_relaxed); }

  // Function for the step interrupt.

  /// Checks the probe; to be called after each step of any motor.
  /// @param contact level of the probe input
  /// @pre armed()
  void look(bool contact, const AxisArray<std::int32_t>& position) noexcept {
    if (contact != contact_) return;
    position_ = position;
    armed_.store(false, std::memory_order_relaxed);
    hit_.store(true, std::memory_order_release);
  }

 private:
  std::atomic<bool> armed_{false};
  std::atomic<bool> hit_{false};
  bool contact_ = true;
  AxisArray<std::int32_t> position_{};
};

}  // namespace cnc
