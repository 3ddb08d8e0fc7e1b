#pragma once

#include <algorithm>
#include <cstdint>

#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// Limits the number of short parts in a row that go into a queue to the step interrupt. A part is
/// a segment or a level of the output.
///
/// The queue holds a fixed number of parts, which have to last until the next parts are added. So
/// the mean duration of parts must be at least a given time, `shortest`. The excess of longer parts
/// over `shortest` is saved, up to kMaxShort · shortest in total. Shorter parts use this saved
/// time. So a motion of duration T has at most T / shortest + kMaxShort parts.
class PartRate {
 public:
  static constexpr std::int32_t kMaxShort = 12;

  /// Returns whether the next part may be shorter than `shortest`.
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
  /// Total time by which later parts may be shorter than shortest_.
  std::int32_t spare_ = kMaxShort * shortest_;
};

/// Limits the rate of segments; times are in ticks. Motors and beams are too slow to respond to a
/// single segment of the shortest time. A queue of 63 such segments lasts six milliseconds.
class SegmentRate : public PartRate {
 public:
  static constexpr std::int32_t kShortest = kTicksPerSecond / 10'000;
  static constexpr std::int32_t kMaxSpare = kMaxShort * kShortest;

  SegmentRate() : PartRate{kShortest} {}
};

/// Limits the rate of levels of the output; times are in nanoseconds. At 32,000 levels per second,
/// a queue of 256 levels lasts eight milliseconds.
class LevelRate : public PartRate {
 public:
  static constexpr std::int32_t kShortest = 31'250;

  LevelRate() : PartRate{kShortest} {}
};

}  // namespace cnc::motion
