#pragma once

#include <algorithm>
#include <cstdint>

#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// How many short parts in a row a queue to the step interrupt can take.
///
/// The queue holds a number of parts, and they have to last until the next ones come in. So parts
/// last a shortest time each on average: longer ones save up for shorter ones, up to kMostShort of
/// them. A part of the motion of time T has T / shortest + kMostShort parts at most.
class PartRate {
 public:
  static constexpr std::int32_t kMostShort = 12;

  /// Returns whether the next part may be shorter than the shortest time.
  [[nodiscard]] bool allows_short() const { return spare_ >= shortest_; }
  /// Counts a part.
  void begin() { spare_ -= shortest_; }
  /// Counts time of the part that was begun last.
  void pass(std::uint32_t time) {
    spare_ = std::min(spare_ + static_cast<std::int32_t>(time), kMostShort * shortest_);
  }

 protected:
  explicit PartRate(std::int32_t shortest) : shortest_{shortest} {}

 private:
  std::int32_t shortest_;
  std::int32_t spare_ = kMostShort * shortest_;  ///< Time by which the parts so far were longer.
};

/// Segments, in ticks: of these motors and beams take no notice, and 63 of them are six
/// milliseconds.
class SegmentRate : public PartRate {
 public:
  static constexpr std::int32_t kShortest = kTicksPerSecond / 10'000;
  static constexpr std::int32_t kMostSpare = kMostShort * kShortest;

  SegmentRate() : PartRate{kShortest} {}
};

/// Levels of the output, in nanoseconds: 32,000 a second, of which 256 are eight milliseconds.
class LevelRate : public PartRate {
 public:
  static constexpr std::int32_t kShortest = 31'250;

  LevelRate() : PartRate{kShortest} {}
};

}  // namespace cnc::motion
