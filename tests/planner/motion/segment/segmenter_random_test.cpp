#include <algorithm>
#include <cmath>

#include "tests/planner/motion/segment/segmenter_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

/// Drives random blocks on a random machine, fed during the motion. An operator holds, resumes and
/// changes every override.
class RandomDrive : public SegmenterTest {
 protected:
  void begin(std::uint64_t seed) {
    random = proof::Random{seed};
    limits = any_limits(random);
    segmenter.reset({});
    segmenter.set_overrides({});
    goal = {};
    steps = {};
    segments.clear();
    ticks = 0;
  }

  void push_any() {
    const float feed = random.chance(0.3) ? 0.0F : static_cast<float>(random.magnitude(5.0, 400.0));
    push(any_element_in_space(random, goal), feed);
  }

  void turn_a_knob() {
    switch (random.below(4)) {
      case 0:
        return segmenter.halt();
      case 1:
        return segmenter.go_on();
      default:
        segmenter.set_overrides({.feed = static_cast<float>(random.between(0.1, 2.0)),
                                 .rapid = static_cast<float>(random.between(0.05, 1.0))});
    }
  }

  void drive_to_the_end() {
    segmenter.go_on();
    drive();
    ASSERT_TRUE(segmenter.idle()) << "stuck with " << queue.size() << " blocks";
    ASSERT_TRUE(segmenter.at_rest());
  }

  proof::Random random{0};
};

TEST_F(RandomDrive, EndsExactlyAtTheLastBlock) {
  for (const std::uint64_t seed : proof::Trials{60}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    begin(seed);
    for (int count = 0; count < 30; ++count) push_any();
    drive_to_the_end();
    ASSERT_EQ(steps, goal_steps());
    ASSERT_TRUE(segments.back().comes_to_rest);
  }
}

TEST_F(RandomDrive, EndsExactlyWhateverTheOperatorDoes) {
  for (const std::uint64_t seed : proof::Trials{60}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    begin(seed);
    for (int round = 0; round < 60; ++round) {
      if (!queue.full()) push_any();
      if (random.chance(0.3)) turn_a_knob();
      drive(static_cast<int>(random.magnitude(1.0, 300.0)));
    }
    drive_to_the_end();
    ASSERT_EQ(steps, goal_steps());
  }
}

TEST_F(RandomDrive, NeverHandsOutMoreThanAMillisecondNorANegativeTime) {
  for (const std::uint64_t seed : proof::Trials{40}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    begin(seed);
    for (int count = 0; count < 20; ++count) push_any();
    drive_to_the_end();
    for (const Segment& segment : segments) {
      ASSERT_GE(segment.ticks, 1U);
      ASSERT_LE(segment.ticks, kMillisecond);
      for (const StepTrain& train : segment.trains) {
        ASSERT_GE(train.first_q16, 0);
      }
    }
  }
}

// No motor receives more steps than its greatest rate allows, except for rounding.
TEST_F(RandomDrive, KeepsTheStepRateOfEveryMotor) {
  for (const std::uint64_t seed : proof::Trials{40}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    begin(seed);
    for (int count = 0; count < 20; ++count) push_any();
    drive_to_the_end();
    for (const Segment& segment : segments) {
      for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const double rate = static_cast<double>(motor_rate(limits, axis)) *
                            static_cast<double>(limits.scale[axis].steps_per_mm());
        const double most = rate * segment.ticks / kTicksPerSecond;
        ASSERT_LE(segment.trains[axis].count, most * 1.001 + 1.01);
      }
    }
  }
}

/// Observes the plan: no axis may exceed its rate or acceleration within a block.
class LimitWatch : public SliceObserver {
 public:
  void on_slice(const Slice& slice) override {
    EXPECT_GE(slice.to_fraction, slice.from_fraction);
    EXPECT_LE(slice.duration, Segmenter::kLongestSlice * 1.0001F);
    // Below a sample of 20 kHz, the rounding error of the speed is not a motion.
    constexpr float kOneSample = 50.0e-6F;
    if (slice.duration < kOneSample) return;
    const double end_speed = static_cast<double>(slice.start_speed) +
                             static_cast<double>(slice.acceleration * slice.duration);
    const double end = static_cast<double>(slice.to_fraction) / 4294967296.0;
    const double start = static_cast<double>(slice.from_fraction) / 4294967296.0;
    judge(slice, start, static_cast<double>(slice.start_speed));
    judge(slice, end, std::max(0.0, end_speed));
  }

  double worst_rate = 0.0;
  double worst_acceleration = 0.0;
  std::vector<PathElement> elements;
  Limits limits;

 private:
  void judge(const Slice& slice, double fraction, double speed) {
    ASSERT_LT(slice.block, elements.size());
    const ExactMotion exact{elements[slice.block]};
    const AxisArray<double> tangent = exact.tangent_at(fraction);
    const AxisArray<double> bend = exact.bend_at(fraction);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const double rate = std::abs(tangent[axis]) * speed;
      const double load = std::abs(tangent[axis] * static_cast<double>(slice.acceleration) +
                                   bend[axis] * squared(speed));
      worst_rate = std::max(worst_rate, rate / static_cast<double>(limits.rate_mm_s[axis]));
      worst_acceleration =
          std::max(worst_acceleration, load / static_cast<double>(limits.acceleration_mm_s2[axis]));
    }
  }
};

TEST_F(RandomDrive, KeepsEveryAxisWithinItsLimits) {
  for (const std::uint64_t seed : proof::Trials{80}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    begin(seed);
    LimitWatch watch;
    watch.limits = limits;
    segmenter.observe(&watch);
    for (int round = 0; round < 30; ++round) {
      const PathElement element = any_element_in_space(random, goal);
      watch.elements.push_back(element);
      push(element, static_cast<float>(random.magnitude(5.0, 400.0)));
      if (random.chance(0.2)) turn_a_knob();
      if (queue.size() > 40) segmenter.go_on();
      drive(static_cast<int>(random.magnitude(1.0, 100.0)));
    }
    drive_to_the_end();
    segmenter.observe(nullptr);
    ASSERT_LE(watch.worst_rate, 1.001);
    ASSERT_LE(watch.worst_acceleration, 1.001);
  }
}

}  // namespace
}  // namespace cnc::motion
