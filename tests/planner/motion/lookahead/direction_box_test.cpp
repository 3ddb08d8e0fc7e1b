#include "planner/motion/lookahead/direction_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

class RandomBox : public testing::Test {
 protected:
  void any() {
    axes = ArcAxes{block_of(any_arc(random), limits), limits, {}};
    first = static_cast<float>(random.between(-4.0, 4.0));
    last = first + static_cast<float>(random.magnitude(1.0e-3, 4.0));
  }

  /// Returns the greatest |axis acceleration| / limit for tangents between `first` and `last`.
  [[nodiscard]] double greatest_load(double tangent, double normal) const {
    constexpr int kSamples = 400;
    double greatest = 0.0;
    for (int sample = 0; sample <= kSamples; ++sample) {
      const double angle =
          std::lerp(static_cast<double>(first), static_cast<double>(last), 1.0 * sample / kSamples);
      for (const ArcAxis& axis : axes) {
        const auto x = static_cast<double>(axis.in_plane.first);
        const auto y = static_cast<double>(axis.in_plane.second);
        const double along = x * std::cos(angle) + y * std::sin(angle);
        const double across = y * std::cos(angle) - x * std::sin(angle);
        const double load = std::abs(tangent * along + normal * across);
        greatest = std::max(greatest, load / static_cast<double>(axis.acceleration));
      }
    }
    return greatest;
  }

  proof::Random random{proof::test_seed()};
  Limits limits = any_limits(random);
  ArcAxes axes;
  float first = 0.0F;
  float last = 0.0F;
};

TEST_F(RandomBox, HoldsTheVectorsThatNoDirectionTakesBeyondAnAxis) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    const DirectionBox box{first, last, axes};
    const double tangent = random.between(-1.0, 1.0);
    const double normal = random.between(-1.0, 1.0);
    const double longest = 1.0 / greatest_load(tangent, normal);
    const auto held = [&](double share) {
      return box.holds(static_cast<float>(tangent * longest * share),
                       static_cast<float>(normal * longest * share));
    };
    ASSERT_TRUE(held(1.0 - 1.0e-4)) << "trial " << trial << ", " << first << " to " << last;
    ASSERT_FALSE(held(1.0 + 1.0e-4)) << "trial " << trial << ", " << first << " to " << last;
  }
}

TEST_F(RandomBox, HoldsItsLongestVectorAlongTheTangent) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    const DirectionBox box{first, last, axes};
    const auto most = static_cast<double>(box.max_along());
    ASSERT_NEAR(greatest_load(most, 0.0), 1.0, 1.0e-4) << "trial " << trial;
  }
}

}  // namespace
}  // namespace cnc::motion
