#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "planner/pipeline/pipeline.hpp"
#include "tests/planner/motion/motion_test.hpp"

namespace cnc {

/// A pipeline, and motors that count its steps, without drives and firmware.
class PipelineTest : public testing::Test {
 protected:
  using Segment = motion::Segment;
  using Steps = AxisArray<std::int32_t>;
  static constexpr std::int32_t kCycleUs = 1000;
  static constexpr int kMaxCycles = 100'000;

  /// Appends a straight move from the target, at 50 mm/s.
  Result<bool, motion::MotionError> go(const Position& end) {
    return pipeline->append(
        {.request = {.element = {.start = pipeline->target(), .end = end}, .feed_mm_s = 50.0F},
         .tolerance = path::tolerance_within(0.01F, 0.002F)});
  }
  /// Takes the next segment; returns false if there is none.
  bool step() {
    Segment segment;
    if (!pipeline->next(segment)) return false;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const auto count = static_cast<std::int32_t>(segment.trains[axis].count);
      motors[axis] += (segment.negative >> axis & 1U) != 0 ? -count : count;
    }
    ticks += segment.ticks;
    rests = segment.comes_to_rest;
    return true;
  }
  /// Runs one cycle of a main loop that takes at most `most` segments.
  int cycle(int most = 100) {
    pipeline->attend(kCycleUs);
    int taken = 0;
    while (taken < most && step()) ++taken;
    return taken;
  }
  /// Drives all appended elements to their end.
  void finish() {
    for (int i = 0; i < kMaxCycles && !pipeline->empty(); ++i) {
      pipeline->flush();
      cycle();
    }
    ASSERT_TRUE(pipeline->empty());
    EXPECT_TRUE(rests);
  }
  void wait_for_room() {
    for (int i = 0; i < kMaxCycles && !pipeline->has_room(); ++i) cycle(1);
    ASSERT_TRUE(pipeline->has_room());
  }
  [[nodiscard]] Steps steps_at(const Position& position) const {
    Steps steps{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      steps[axis] = limits.scale[axis].steps_at(position[axis])->nearest_step();
    }
    return steps;
  }
  [[nodiscard]] double seconds() const {
    return static_cast<double>(ticks) / motion::kTicksPerSecond;
  }

  motion::Limits limits = motion::plain_limits();
  motion::Pixels pixels;
  std::unique_ptr<Pipeline> pipeline = std::make_unique<Pipeline>(limits, pixels);
  Steps motors{};
  std::uint64_t ticks = 0;
  bool rests = true;
};

}  // namespace cnc
