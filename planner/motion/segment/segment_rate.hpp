#pragma once

#include <algorithm>
#include <cstdint>

#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// How many short segments in a row the queue to the step interrupt can take.
///
/// The queue holds a number of segments, and they have to last until the next ones come in. So
/// segments last kShortest each on average: longer ones save up for shorter ones, up to kMostSpare.
/// A part of the motion of T ticks has (T + kMostSpare) / kShortest segments at most.
class SegmentRate {
 public:
  /// Ticks: of these motors and beams take no notice, and 63 of them are six milliseconds.
  static constexpr std::int32_t kShortest = kTicksPerSecond / 10'000;
  static constexpr std::int32_t kMostSpare = 12 * kShortest;

  /// Returns whether the next segment may be shorter than kShortest.
  [[nodiscard]] bool allows_short() const { return spare_ >= kShortest; }
  /// Counts a segment.
  void begin() { spare_ -= kShortest; }
  /// Counts a part of the segment that was begun last.
  void pass(std::uint32_t ticks) {
    spare_ = std::min(spare_ + static_cast<std::int32_t>(ticks), kMostSpare);
  }

 private:
  std::int32_t spare_ = kMostSpare;  ///< Ticks by which the segments so far were longer.
};

}  // namespace cnc::motion
