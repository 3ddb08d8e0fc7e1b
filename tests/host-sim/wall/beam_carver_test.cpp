#include "host-sim/wall/carve/beam_carver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "host-sim/wall/carve/beam_strokes.hpp"
#include "tests/host-sim/wall/burn_oracle.hpp"
#include "tests/host-sim/wall/degrees.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

constexpr stock::StockBox kBlock{-1.0, -1.0, 1.0, 1.0, 0.0, -2.0};

BeamPose random_pose(proof::Random& random, double most_tilt) {
  const double tilt = random.chance(0.2) ? 0.0 : random.between(0.0, most_tilt);
  const double towards = random.between(0.0, 360.0 * kDegree);
  return {{random.between(-1.2, 1.2), random.between(-1.2, 1.2), random.between(-2.1, 0.1)},
          {std::sin(tilt) * std::cos(towards), std::sin(tilt) * std::sin(towards), std::cos(tilt)},
          random.chance(0.5) ? random.between(0.0, 0.4) : 0.0};
}

/// Returns a stroke whose axis is constant, or turns.
BeamStroke random_stroke(proof::Random& random, double most_tilt) {
  const bool turns = random.chance(0.3);
  const bool is_level = random.chance(0.5);
  BeamStroke stroke{random_pose(random, most_tilt)};
  const std::size_t count = 1 + random.below(3);
  while (stroke.size() < count) {
    BeamPose pose = random_pose(random, most_tilt);
    if (!turns) pose.axis = stroke.front().axis;
    if (is_level) pose.tip.z() = stroke.front().tip.z();
    stroke.push_back(pose);
  }
  return stroke;
}

/// Returns the depth of a point within the volume that the strokes burn, mm; negative outside.
double burned_depth(const std::vector<BeamStroke>& strokes,
                    const BurningBeam& beam,
                    const Vector3d& point) {
  double depth = -1.0e9;
  for (const BeamStroke& stroke : strokes) {
    depth = std::max(depth, burn_oracle::depth_of(stroke, beam, point));
  }
  return depth;
}

TEST(BeamCarver, BurnsThePointsThatBruteForceBurns) {
  const proof::Trials trials{300};
  std::size_t burned = 0;
  std::size_t kept = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    BurningBeam beam{.half_angle_rad = random.between(1.0, 30.0) * kDegree,
                     .heat_rad = random.chance(0.5) ? random.between(0.0, 10.0) * kDegree : 0.0,
                     .waist_mm = random.chance(0.3) ? 0.0 : random.between(0.01, 0.3)};
    std::vector<BeamStroke> strokes;
    for (std::size_t i = 1 + random.below(4); i > 0; --i) {
      strokes.push_back(random_stroke(random, 45.0 * kDegree));
    }
    Columns columns{kBlock, 0.05};
    BeamCarver carver{columns, beam};
    for (const BeamStroke& stroke : strokes) carver.carve(stroke);
    for (int i = 0; i < 200; ++i) {
      const int column =
          static_cast<int>(random.below(static_cast<std::size_t>(columns.columns())));
      const int row = static_cast<int>(random.below(static_cast<std::size_t>(columns.rows())));
      const double z = random.between(-2.0, 0.0);
      const double depth =
          burned_depth(strokes, beam, {columns.x_of(column), columns.y_of(row), z});
      // Swings burn a little more than the exact volume, never less.
      constexpr double kRounding = 1.0e-7;
      constexpr double kSwing = 4.0 * kSwingErrorMm;
      const bool is_left = columns.has(column, row, z);
      EXPECT_FALSE(is_left && depth > kRounding) << depth << " mm within";
      EXPECT_FALSE(!is_left && depth < -kSwing) << depth << " mm within";
      (is_left ? kept : burned) += 1;
    }
  }
  EXPECT_GT(burned, 0U);
  EXPECT_GT(kept, 0U);
}

}  // namespace
}  // namespace sim::wall
