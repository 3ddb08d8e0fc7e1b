#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "planner/motion/segment/segmenter.hpp"
#include "tests/planner/motion/motion_test.hpp"

namespace cnc::motion {

inline constexpr std::uint32_t kMillisecond = kTicksPerSecond / 1000;

/// A segmenter with a queue, and the segments that it has returned.
class SegmenterTest : public testing::Test {
 protected:
  void push(const PathElement& element, float feed_mm_s = 0.0F) {
    queue.push(block_of(element, limits, feed_mm_s));
    goal = element.end;
  }
  /// Pushes a straight move along X from the end of the motion so far.
  void push_to(double x_mm,
               float feed_mm_s = 0.0F,
               BeamCommand beam = {},
               OutputChanges outputs = {}) {
    PathElement element{.start = goal, .end = goal};
    element.end[0] = Coordinate{std::llround(x_mm * 1.0e6)};
    const auto built = build_block(
        {.element = element, .feed_mm_s = feed_mm_s, .beam = beam, .outputs = outputs}, limits);
    ASSERT_TRUE(built.ok());
    queue.push(built.value());
    goal = element.end;
  }

  /// Takes one more segment; returns false if there is none.
  bool step() {
    Segment segment;
    if (!segmenter.next(segment)) return false;
    segments.push_back(segment);
    ticks += segment.ticks;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const auto count = static_cast<std::int32_t>(segment.trains[axis].count);
      steps[axis] += (segment.negative >> axis & 1U) != 0 ? -count : count;
    }
    return true;
  }
  /// Takes segments until there are none left, but at most `most`.
  void drive(int most = 1'000'000) {
    while (most-- > 0 && step()) {
    }
  }

  /// Returns the positions of the motors when all blocks are driven.
  [[nodiscard]] AxisArray<std::int32_t> goal_steps() const {
    AxisArray<std::int32_t> at{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      at[axis] = limits.scale[axis].steps_at(goal[axis])->nearest_step();
    }
    return at;
  }
  [[nodiscard]] double seconds() const { return static_cast<double>(ticks) / kTicksPerSecond; }

  Limits limits = plain_limits();
  BlockQueueOf<kLookAheadBlocks> queue;
  Segmenter segmenter{queue, limits};
  Position goal{};
  std::vector<Segment> segments;
  AxisArray<std::int32_t> steps{};
  std::uint64_t ticks = 0;
};

}  // namespace cnc::motion
