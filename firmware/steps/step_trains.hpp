#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/motion/segment.hpp"

namespace cnc {

/// Where the motors are, in steps: written by the step interrupt, read by the main loop.
using MotorSteps = AxisArray<std::atomic<std::int32_t>>;

/// The step trains of the segment being played, of the motors that still have steps in it.
/// Step interrupt only; integers.
class StepTrains {
 public:
  static constexpr std::int32_t kNever = 0x7FFF'FFFF;

  /// Takes the trains of a segment. @pre empty(). @return the axes that have any.
  std::uint8_t load(const motion::Segment& segment) noexcept {
    std::uint8_t moving = 0;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const motion::StepTrain& train = segment.trains[axis];
      if (train.count == 0) continue;
      const auto bit = static_cast<std::uint8_t>(1U << axis);
      motors_[count_++] = {.due_q16 = train.first_q16,
                           .interval_q16 = train.interval_q16,
                           .growth_q16 = train.growth_q16,
                           .way = (segment.negative & bit) != 0 ? -1 : 1,
                           .left = train.count,
                           .axis = static_cast<std::uint8_t>(axis)};
      earliest_q16_ = std::min(earliest_q16_, train.first_q16);
      moving = static_cast<std::uint8_t>(moving | bit);
    }
    return moving;
  }
  void clear() noexcept {
    count_ = 0;
    earliest_q16_ = kNever;
  }

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  /// Tick of the segment in which the next step of any motor is due. @pre !empty()
  [[nodiscard]] std::int32_t next_due() const noexcept { return earliest_q16_ >> 16; }

  /// Takes the steps that are due before this tick, one of each motor at most, and counts
  /// them. @return their axes.
  std::uint8_t take_before(std::int32_t tick, MotorSteps& position) noexcept {
    std::uint8_t due = 0;
    std::int32_t earliest = kNever;
    for (std::size_t i = 0; i < count_;) {
      Motor& motor = motors_[i];
      if ((motor.due_q16 >> 16) < tick) {
        due = static_cast<std::uint8_t>(due | (1U << motor.axis));
        std::atomic<std::int32_t>& steps = position[motor.axis];
        steps.store(steps.load(std::memory_order_relaxed) + motor.way, std::memory_order_relaxed);
        if (--motor.left == 0) {
          motor = motors_[--count_];
          continue;
        }
        motor.due_q16 += motor.interval_q16;
        motor.interval_q16 += motor.growth_q16;
      }
      earliest = std::min(earliest, motor.due_q16);
      ++i;
    }
    earliest_q16_ = earliest;
    return due;
  }

 private:
  struct Motor {
    std::int32_t due_q16 = 0;  ///< Its next step, in ticks of the segment.
    std::int32_t interval_q16 = 0;
    std::int32_t growth_q16 = 0;
    std::int32_t way = 1;    ///< Of a step: 1, or −1 backwards.
    std::uint16_t left = 0;  ///< Steps.
    std::uint8_t axis = 0;
  };

  AxisArray<Motor> motors_{};
  std::size_t count_ = 0;
  std::int32_t earliest_q16_ = kNever;
};

}  // namespace cnc
