#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/motion/block/output_changes.hpp"
#include "planner/motion/block/source_line.hpp"

namespace cnc::motion {

/// The clock of the step generator. 4 MHz divides the timer clock of the
/// STM32F405 (84 MHz / 21), is a whole number of nanoseconds (250), and is a
/// hundred times finer than the timing promise of 25 µs.
inline constexpr std::uint32_t kTicksPerSecond = 4'000'000;
inline constexpr std::uint32_t kNsPerTick = 1'000'000'000 / kTicksPerSecond;

/// The integer that stands for a full output: the beam or spindle, an analog channel.
inline constexpr float kFullOutput = 65535.0F;

/// Steps of one motor within a segment: step k (0, 1, …) is due at
///   first + k · interval + k (k − 1) / 2 · growth
/// ticks after the start of the segment, all in Q16 ticks. Second order in k
/// follows an acceleration within the segment.
struct StepTrain {
  std::int32_t first_q16 = 0;
  std::int32_t interval_q16 = 0;
  std::int32_t growth_q16 = 0;
  std::uint16_t count = 0;
};

/// A stretch of the beam or spindle output: `first`, and then at every
/// `interval` ticks `growth_q8` / 256 more. Never leaves 0…65535.
struct PowerCourse {
  static constexpr std::uint16_t kLongestInterval = kTicksPerSecond / 10'000;  ///< 100 µs.

  std::int32_t growth_q8 = 0;  ///< 0 is constant.
  std::uint16_t first = 0;     ///< Output duty, 65535 is full.
  std::uint16_t interval = kLongestInterval;

  [[nodiscard]] constexpr bool dark() const { return first == 0 && growth_q8 == 0; }
  constexpr bool operator==(const PowerCourse&) const = default;
};

/// From this tick of a segment on the output has this duty.
struct PowerLevel {
  std::uint16_t from = 0;
  std::uint16_t duty = 0;  ///< 65535 is full.
};

/// What the step interrupt plays: a slice of at most a millisecond of one
/// block. Plain integers; no axis reverses within it.
struct Segment {
  /// Pixels that last 36 µs of a segment of 250 µs have one each, and the first needs none.
  static constexpr std::size_t kMostLevels = 6;

  std::uint32_t ticks = 0;    ///< Length of the slice.
  PowerCourse power{};        ///< To the first of the levels, or over its whole length.
  std::uint8_t negative = 0;  ///< Bit i: axis i runs backwards.
  std::uint8_t level_count = 0;
  bool comes_to_rest = false;  ///< The plan stands still after it: an empty queue is no fault.
  OutputChanges outputs{};     ///< At its start.
  SourceLine line{};           ///< Where it begins, or one before.
  std::array<PowerLevel, kMostLevels> levels{};  ///< In order; from a tick within it.
  AxisArray<StepTrain> trains{};

  /// Returns whether the output is 0 all along.
  [[nodiscard]] constexpr bool dark() const {
    for (std::size_t i = 0; i < level_count; ++i) {
      if (levels[i].duty != 0) return false;
    }
    return power.dark();
  }
};

}  // namespace cnc::motion
