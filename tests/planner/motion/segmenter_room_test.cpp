#include <cmath>

#include "tests/planner/motion/segmenter_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

/// One that is held, and one that moves meanwhile.
class SegmenterRoomTest : public SegmenterTest {
 protected:
  /// The other one goes so far along X, and ends there.
  void make_side_trip(double x_mm) {
    other.reset({});
    other_queue.push(straight_block(x_mm, limits));
    for (Segment segment; other.next(segment);) {
      Segment none;
      EXPECT_FALSE(segmenter.next(none));
    }
    EXPECT_EQ(limits.scale[0].steps_at(place({x_mm})[0])->q32(), other.place()[0].q32());
  }
  void halt() {
    segmenter.halt();
    drive();
    ASSERT_TRUE(segmenter.halted());
  }

  BlockQueueOf<1> other_queue;
  Segmenter other{other_queue, limits, room};
};

TEST_F(SegmenterRoomTest, ABeginningWaitsUntilTheOtherStands) {
  push_to(20.0);
  other.reset({});
  other_queue.push(straight_block(1.0, limits));
  Segment segment;
  ASSERT_TRUE(other.next(segment));
  EXPECT_FALSE(step());
  while (other.next(segment)) {
  }
  drive();
  EXPECT_EQ(goal_steps(), steps);
}

TEST_F(SegmenterRoomTest, AHaltedOneTakesItBackWithinItsBlock) {
  for (const float jerk : {0.0F, 20'000.0F}) {
    limits.jerk_mm_s3.fill(jerk);
    push_to(20.0);
    push_to(-5.0);
    drive(8);
    halt();
    make_side_trip(-3.0);
    make_side_trip(2.0);
    segmenter.go_on();
    drive();
    EXPECT_TRUE(segmenter.idle());
    EXPECT_EQ(goal_steps(), steps);
  }
}

TEST_F(SegmenterRoomTest, WhoForgetsAllLeavesTheRoom) {
  push_to(20.0);
  drive(4);
  segmenter.reset({});
  make_side_trip(1.0);
}

/// Against the same with a room for itself: as long, and to the same place.
TEST_F(SegmenterRoomTest, MakesNoDifferenceToAnyMotion) {
  // After a side trip some motions take longer than the bound, as that of seed 2882690759.
  const proof::Trials trials{300, proof::Trials::Range::kFromBaseInProve};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    std::array<double, 2> time_s{};
    for (const bool shared : {false, true}) {
      proof::Random random{seed};
      limits = any_limits(random);
      if (random.chance(0.7))
        limits.jerk_mm_s3.fill(static_cast<float>(random.magnitude(2e3, 2e6)));
      segmenter.reset({});
      segmenter.go_on();
      goal = {};
      steps = {};
      ticks = 0;
      for (int blocks = 0; blocks < 4; ++blocks) push(any_element(random, goal));
      // Once: a second halt would find it elsewhere by a rounding.
      drive(static_cast<int>(random.below(200)));
      halt();
      if (shared) make_side_trip(2.0);
      segmenter.go_on();
      drive();
      EXPECT_TRUE(segmenter.idle());
      EXPECT_EQ(goal_steps(), steps);
      time_s[shared ? 1 : 0] = seconds();
    }
    EXPECT_NEAR(time_s[0], time_s[1], 1e-5 * time_s[0] + 1e-4);
  }
}

}  // namespace
}  // namespace cnc::motion
