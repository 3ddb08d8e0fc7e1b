#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/motion/block/output_changes.hpp"
#include "planner/motion/block/source_line.hpp"

namespace cnc::motion {

/// Frequency of the step generator's clock, in Hz: the timer clock of the STM32F405, 84 MHz,
/// divided by 21. A tick is a whole number of nanoseconds (250), a hundred times finer than the
/// timing promise of 25 µs.
inline constexpr std::uint32_t kTicksPerSecond = 4'000'000;
inline constexpr std::uint32_t kNsPerTick = 1'000'000'000 / kTicksPerSecond;

/// Integer value of full output of the beam, the spindle or an analog channel.
inline constexpr float kFullOutput = 65535.0F;

/// Steps of one motor within a segment. Step k (0, 1, …) is due at
///   first + k · interval + k (k − 1) / 2 · growth
/// ticks after the start of the segment, all in Q16 ticks. The term in k² represents the
/// acceleration within the segment.
struct StepTrain {
  std::int32_t first_q16 = 0;
  std::int32_t interval_q16 = 0;
  std::int32_t growth_q16 = 0;
  std::uint16_t count = 0;
};

/// Profile of the beam or spindle output over a part of the motion. The output starts at `first`,
/// changes by `growth_q8` / 256 every `interval` ticks, and never leaves 0…65535.
struct PowerCourse {
  static constexpr std::uint16_t kLongestInterval = kTicksPerSecond / 10'000;  ///< 100 µs.

  std::int32_t growth_q8 = 0;  ///< Change per interval, times 256; 0 is a constant output.
  std::uint16_t first = 0;     ///< Output duty, 65535 is full.
  std::uint16_t interval = kLongestInterval;

  [[nodiscard]] constexpr bool dark() const { return first == 0 && growth_q8 == 0; }
  constexpr bool operator==(const PowerCourse&) const = default;
};

/// A constant level of the output, `duty`, that begins at tick `from` of a segment.
struct PowerLevel {
  std::uint16_t from = 0;
  std::uint16_t duty = 0;  ///< 65535 is full.
};

/// A part of the motion that the step interrupt executes: one slice, or several short slices
/// joined. It lasts at most a millisecond. All values are plain integers. No axis reverses within a
/// segment.
struct Segment {
  /// Greatest number of levels. It is enough for a segment of 250 µs with pixels of 36 µs: `power`
  /// gives the output of the first pixel, and each further pixel has a level.
  static constexpr std::size_t kMaxLevels = 6;

  std::uint32_t ticks = 0;  ///< Duration of the segment.
  /// Power from the start of the segment to its first level, or to its end if it has no level.
  PowerCourse power{};
  std::uint8_t negative = 0;  ///< Bit i: axis i runs backwards.
  std::uint8_t level_count = 0;
  /// True if the motion is at rest after the segment. Then an empty queue is no fault.
  bool comes_to_rest = false;
  OutputChanges outputs{};  ///< Changes at the start of the segment.
  SourceLine line{};        ///< Source line at the start of the segment, or an earlier line.
  std::array<PowerLevel, kMaxLevels> levels{};  ///< Levels in order of time.
  AxisArray<StepTrain> trains{};

  /// Returns whether the output is 0 during the whole segment.
  [[nodiscard]] constexpr bool dark() const {
    for (std::size_t i = 0; i < level_count; ++i) {
      if (levels[i].duty != 0) return false;
    }
    return power.dark();
  }
};

}  // namespace cnc::motion
