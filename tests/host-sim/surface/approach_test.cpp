#include "host-sim/surface/approach.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST(Approach, TurnsTheDirectionDownAndKeepsShapes) {
  const proof::Trials trials{1'000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Vector3d direction{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    const Matrix3d turn = turn_for_approach(random.magnitude(0.01, 100.0) * direction);
    EXPECT_LT((turn * direction.normalized() + Vector3d::UnitZ()).norm(), 1.0e-11);
    EXPECT_LT((turn * turn.transpose() - Matrix3d::Identity()).norm(), 1.0e-11);
    EXPECT_NEAR(turn.determinant(), 1.0, 1.0e-11);
    // The shortest rotation is about a horizontal axis, at right angles to the direction.
    const Vector3d axis = direction.cross(Vector3d::UnitZ()).normalized();
    EXPECT_LT((turn * axis - axis).norm(), 1.0e-9);
  }
}

TEST(Approach, AlongAxesHasNoRounding) {
  EXPECT_EQ(turn_for_approach({0, 0, -2}), Matrix3d::Identity());
  EXPECT_EQ(turn_for_approach({0, 0, 1}) * Vector3d(1, 2, 3), Vector3d(1, -2, -3));
  EXPECT_EQ(turn_for_approach({-3, 0, 0}) * Vector3d(1, 2, 3), Vector3d(-3, 2, 1));
  EXPECT_EQ(turn_for_approach({1, 0, 0}) * Vector3d(1, 2, 3), Vector3d(3, 2, -1));
  EXPECT_EQ(turn_for_approach({0, -1, 0}) * Vector3d(1, 2, 3), Vector3d(1, -3, 2));
  EXPECT_EQ(turn_for_approach({0, 1, 0}) * Vector3d(1, 2, 3), Vector3d(1, 3, -2));
}

}  // namespace
}  // namespace sim::surface
