#pragma once

#include <algorithm>
#include <cstdint>

#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// Limits how many short parts in a row go into a queue to the step interrupt.
///
/// The queue holds a fixed number of parts, which have to last until the next ones come in. So on
/// average each part must last a shortest time. Longer parts save time for shorter ones, up to the
/// time of kMaxShort parts. A motion that takes the time T has at most T / shortest + kMaxShort
/// parts.
class PartRate {
 public:
  static constexpr std::int32_t kMaxShort = 12;

  /// Returns whether the next part may be shorter than the shortest time.
  [[nodiscard]] bool allows_short() const { return spare_ >= shortest_; }
  /// Counts the beginning of a part.
  void begin() { spare_ -= shortest_; }
  /// Adds time to the part that was begun last.
  void pass(std::uint32_t time) {
    spare_ = std::min(spare_ + static_cast<std::int32_t>(time), kMaxShort * shortest_);
  }

 protected:
  explicit PartRate(std::int32_t shortest) : shortest_{shortest} {}

 private:
  std::int32_t shortest_;
  std::int32_t spare_ = kMaxShort * shortest_;  ///< Time that earlier parts have saved.
};

/// Limits the rate of segments; times are in ticks. Motors and beams do not react to segments of
/// the shortest time, and 63 of these last six milliseconds.
class SegmentRate : public PartRate {
 public:
  static constexpr std::int32_t kShortest = kTicksPerSecond / 10'000;
  static constexpr std::int32_t kMaxSpare = kMaxShort * kShortest;

  SegmentRate() : PartRate{kShortest} {}
};

/// Limits the rate of levels of the output; times are in nanoseconds. At 32,000 levels a second,
/// 256 of them last eight milliseconds.
class LevelRate : public PartRate {
 public:
  static constexpr std::int32_t kShortest = 31'250;

  LevelRate() : PartRate{kShortest} {}
};

}  // namespace cnc::motion
