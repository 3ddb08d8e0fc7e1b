#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/base/contract.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// A segment with values that the main loop computes ahead for the step interrupt.
struct PlayableSegment {
  motion::Segment segment{};
  std::uint32_t moving = 0;       ///< Bit i: axis i has steps.
  std::int32_t earliest_q16 = 0;  ///< Time of the first step of any axis.

  void prepare() {
    moving = 0;
    earliest_q16 = kNoStep;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const motion::StepTrain& train = segment.trains[axis];
      if (train.count == 0) continue;
      moving |= 1U << axis;
      earliest_q16 = std::min(earliest_q16, train.first_q16);
    }
  }

  static constexpr std::int32_t kNoStep = 0x7FFF'FFFF;
};

/// The step trains of the segment being played. The trains are changed in the queue itself and not
/// copied, so that a segment begins at little cost: `first_q16` is the time of the next step, and
/// `count` the number of steps left. Step interrupt only; integers.
class StepTrains {
 public:
  /// Begins the trains of the segment `next`, which must not change its address before empty()
  /// returns true.
  /// @pre empty()
  void begin(PlayableSegment& next) noexcept {
    trains_ = next.segment.trains.data();
    negative_ = next.segment.negative;
    moving_ = next.moving;
    earliest_q16_ = next.earliest_q16;
#pragma GCC unroll 6
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      ends_[axis] += way(axis, trains_[axis].count);
    }
  }
  /// Drops the remaining steps.
  void clear() noexcept {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) ends_[axis] = position(axis);
    moving_ = 0;
  }

  [[nodiscard]] bool empty() const noexcept { return moving_ == 0; }
  /// Returns the tick of the segment at which the next step of any motor is due.
  /// @pre !empty()
  [[nodiscard]] std::int32_t next_due() const noexcept { return earliest_q16_ >> 16; }

  /// Takes the steps that are due before `tick`, at most one of each motor.
  /// @return axes whose motors step, bit i for axis i
  std::uint8_t take_before(std::int32_t tick) noexcept {
    unsigned due = 0;
    unsigned moving = moving_;
    std::int32_t earliest = PlayableSegment::kNoStep;
    // The loop is unrolled, so that each motor's train has a constant offset from `trains_`.
#pragma GCC unroll 6
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const unsigned bit = 1U << axis;
      if ((moving & bit) == 0) continue;
      motion::StepTrain& train = trains_[axis];
      std::int32_t next = train.first_q16;
      if ((next >> 16) < tick) {
        due |= bit;
        const int steps_left = train.count - 1;
        train.count = static_cast<std::uint16_t>(steps_left);
        next += train.interval_q16;
        train.first_q16 = next;
        train.interval_q16 += train.growth_q16;
        if (steps_left <= 0) {
          CNC_ASSERT(steps_left == 0);  // Otherwise memory was corrupted.
          moving ^= bit;
          continue;
        }
      }
      earliest = std::min(earliest, next);
    }
    moving_ = moving;
    earliest_q16_ = earliest;
    return static_cast<std::uint8_t>(due);
  }

  /// Returns the position of a motor in steps.
  [[nodiscard]] std::int32_t position(std::size_t axis) const noexcept {
    if ((moving_ >> axis & 1U) == 0) return ends_[axis];
    return ends_[axis] - way(axis, trains_[axis].count);
  }
  [[nodiscard]] AxisArray<std::int32_t> position() const noexcept {
    AxisArray<std::int32_t> steps{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) steps[axis] = position(axis);
    return steps;
  }
  /// Sets the position of a motor without moving it.
  /// @pre empty()
  void set_position(std::size_t axis, std::int32_t steps) noexcept { ends_[axis] = steps; }

 private:
  [[nodiscard]] std::int32_t way(std::size_t axis, std::int32_t steps) const noexcept {
    return (negative_ >> axis & 1U) != 0 ? -steps : steps;
  }

  motion::StepTrain* trains_ = nullptr;
  unsigned moving_ = 0;  ///< Axes that still have steps.
  std::int32_t earliest_q16_ = PlayableSegment::kNoStep;
  std::uint32_t negative_ = 0;
  AxisArray<std::int32_t> ends_{};  ///< Motor positions after all steps of the trains.
};

}  // namespace cnc
