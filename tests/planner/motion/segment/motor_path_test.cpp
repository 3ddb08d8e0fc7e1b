#include "planner/motion/segment/motor_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

constexpr std::uint64_t kWhole = std::uint64_t{1} << 32;

double in_steps(StepPosition position) { return static_cast<double>(position.q32()) / kOneStep; }

/// Motor positions and speeds at one time.
struct MotorState {
  AxisArray<StepPosition> place{};
  AxisArray<float> speed{};  ///< Speed of each motor, steps per mm of path.
};

class RandomMotorPath : public testing::Test {
 protected:
  void any() {
    limits = any_limits(random);
    Position start;
    for (Coordinate& axis : start) axis = Coordinate{std::llround(random.between(-3.0e8, 3.0e8))};
    element = any_element_in_space(random, start);
    prepare();
  }

  void prepare() {
    block = block_of(element, limits);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      from[axis] = *limits.scale[axis].steps_at(element.start[axis]);
    }
    path = MotorPath{block, from};
  }

  [[nodiscard]] MotorState state_at(std::uint64_t fraction) const {
    MotorState state{.place = from};
    const MotorPath::Point point = path.at(fraction);
    for (const MotorPath::Motor& motor : path.moving()) {
      state.place[motor.axis()] = motor.place(point);
      state.speed[motor.axis()] = motor.speed(point);
    }
    return state;
  }

  /// Returns the distance in mm between the actual and the exact position of an axis.
  [[nodiscard]] double error_mm(std::size_t axis, double fraction) const {
    const auto resolution = static_cast<double>(limits.scale[axis].steps_per_mm());
    const MotorState state = state_at(static_cast<std::uint64_t>(fraction * kOneStep));
    const double moved = in_steps(state.place[axis]) - in_steps(from[axis]);
    return moved / resolution - ExactMotion{element}.place_at(fraction)[axis];
  }

  proof::Random random{proof::test_seed()};
  Limits limits;
  PathElement element;
  Block block;
  AxisArray<StepPosition> from{};
  MotorPath path;
};

TEST_F(RandomMotorPath, EndsExactlyWhereTheBlockEnds) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    ASSERT_EQ(state_at(kWhole).place, block.end);
  }
}

TEST_F(RandomMotorPath, StartsWhereItIsToldTo) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      ASSERT_NEAR(error_mm(axis, 0.0), 0.0, 2.0e-6) << "trial " << trial;
    }
  }
}

TEST_F(RandomMotorPath, IsWithinHalfAMicrometreOfTheExactCurve) {
  for (int trial = 0; trial < 50'000; ++trial) {
    any();
    const double fraction = random.unit();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      ASSERT_NEAR(error_mm(axis, fraction), 0.0, 0.5e-3)
          << "trial " << trial << ", bulge " << element.bulge << ", fraction " << fraction;
    }
  }
}

// Half a micrometre at R = 2000 is 2.5e-7 of the radius.
TEST_F(RandomMotorPath, IsWithinHalfAMicrometreOfTheGreatestArcs) {
  limits = plain_limits();
  double worst = 0.0;
  for (int trial = 0; trial < 50'000; ++trial) {
    const double bulge = random.signed_magnitude(0.001, 1.0);
    const double chord = 4000.0 * 2.0 * std::abs(bulge) / (1.0 + bulge * bulge);
    const double way = random.between(-3.14, 3.14);
    element = {.end = place({chord * std::cos(way), chord * std::sin(way)}),
               .bulge = static_cast<float>(bulge)};
    prepare();
    const double fraction = random.unit();
    const double off = std::hypot(error_mm(0, fraction), error_mm(1, fraction));
    worst = std::max(worst, off);
  }
  EXPECT_LE(worst, 0.5e-3);
}

TEST_F(RandomMotorPath, JumpsNowhere) {
  for (int trial = 0; trial < 2'000; ++trial) {
    any();
    MotorState before = state_at(0);
    for (std::uint64_t part = 1; part <= 256; ++part) {
      const MotorState now = state_at(part << 24);
      for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const double moved = in_steps(now.place[axis]) - in_steps(before.place[axis]);
        const auto resolution = static_cast<double>(limits.scale[axis].steps_per_mm());
        const double most = static_cast<double>(block.length) * resolution / 256.0;
        ASSERT_LE(std::abs(moved), most * 1.001 + 0.01) << "trial " << trial << ", part " << part;
      }
      before = now;
    }
  }
}

TEST_F(RandomMotorPath, KnowsItsSpeed) {
  for (int trial = 0; trial < 50'000; ++trial) {
    any();
    const double fraction = random.unit();
    const MotorState state = state_at(static_cast<std::uint64_t>(fraction * kOneStep));
    const AxisArray<double> tangent = ExactMotion{element}.tangent_at(fraction);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const auto resolution = static_cast<double>(limits.scale[axis].steps_per_mm());
      ASSERT_NEAR(static_cast<double>(state.speed[axis]) / resolution, tangent[axis], 4.0e-6)
          << "trial " << trial << ", axis " << axis;
    }
  }
}

TEST_F(RandomMotorPath, ReversesNoAxisBetweenQuarterTurns) {
  limits = plain_limits();
  element = {.end = place({20.0, 20.0}),
             .bulge = 0.41421356F};  // A quarter turn, from along X to along Y.
  prepare();
  MotorState before = state_at(0);
  for (std::uint64_t part = 1; part <= 4096; ++part) {
    const MotorState now = state_at(part << 20);
    ASSERT_GE(now.place[0].q32() - before.place[0].q32(), -8) << part;
    ASSERT_GE(now.place[1].q32() - before.place[1].q32(), -8) << part;
    before = now;
  }
}

}  // namespace
}  // namespace cnc::motion
