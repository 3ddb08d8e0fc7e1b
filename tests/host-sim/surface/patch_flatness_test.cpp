#include <gtest/gtest.h>

#include "host-sim/surface/patch/flatness.hpp"
#include "host-sim/surface/patch/subdivision.hpp"
#include "tests/host-sim/surface/patch_exact.hpp"
#include "tests/host-sim/surface/patch_support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

TEST(PatchFlatness, TighterTestsHoldThePatch) {
  for (const std::uint64_t seed : proof::Trials{2000}) {
    proof::Random random{seed};
    const BezierPatch patch = random_patch(random);
    const FatPlane hull = fat_plane(patch, FlatnessTest::kControlHull);
    const FatPlane paper = fat_plane(patch, FlatnessTest::kFatPlane);
    const FatPlane both = fat_plane(patch, FlatnessTest::kBothOrders);
    const Range exact = exact_range(patch, both.normal);
    const double slack = 1.0e-12 * (1.0 + hull.flatness());
    EXPECT_NEAR(hull.normal.norm(), 1.0, 1.0e-15) << "KERFLINE_SEED=" << seed;
    EXPECT_LE(hull.distances.lowest, paper.distances.lowest + slack) << "KERFLINE_SEED=" << seed;
    EXPECT_LE(paper.distances.lowest, both.distances.lowest) << "KERFLINE_SEED=" << seed;
    EXPECT_LE(both.distances.lowest, exact.lowest + slack) << "KERFLINE_SEED=" << seed;
    EXPECT_GE(hull.distances.highest, paper.distances.highest - slack) << "KERFLINE_SEED=" << seed;
    EXPECT_GE(paper.distances.highest, both.distances.highest) << "KERFLINE_SEED=" << seed;
    EXPECT_GE(both.distances.highest, exact.highest - slack) << "KERFLINE_SEED=" << seed;
  }
}

TEST(PatchFlatness, BothOrdersDoNotDependOnTheOrder) {
  for (const std::uint64_t seed : proof::Trials{1000}) {
    proof::Random random{seed};
    const BezierPatch patch = random_patch(random);
    const double flatness = fat_plane(patch, FlatnessTest::kBothOrders).flatness();
    EXPECT_NEAR(fat_plane(patch.transposed(), FlatnessTest::kBothOrders).flatness(),
                flatness,
                1.0e-12 * (1.0 + flatness))
        << "KERFLINE_SEED=" << seed;
  }
}

TEST(PatchFlatness, DegeneratePatchesHaveANormal) {
  BezierPatch patch;
  EXPECT_EQ(normal_of(patch), Vector3d::UnitZ());
  EXPECT_EQ(fat_plane(patch, FlatnessTest::kBothOrders).flatness(), 0.0);
  // Diagonals have the same direction, as in a patch that is pulled to a triangle and folded.
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto x = static_cast<double>(i);
      patch.rows[i].controls[j] = {x, i == 0 || i == 3 ? 0.0 : static_cast<double>(j), 0.0};
    }
  }
  EXPECT_NEAR(std::abs(normal_of(patch).z()), 1.0, 1.0e-12);
}

/// Checks that pieces are flat, cover the patch once, and lie on its surface.
void check_pieces(const GridPatch& patch,
                  const std::vector<GridPatch>& pieces,
                  const FlatnessLimit& limit) {
  double area = 0.0;
  for (const GridPatch& piece : pieces) {
    EXPECT_LE(chord_error_bound(piece.shape, limit), limit.tolerance_mm);
    area += (piece.u.to - piece.u.from) * (piece.v.to - piece.v.from);
    const Interval u{(piece.u.from - patch.u.from) / (patch.u.to - patch.u.from),
                     (piece.u.to - patch.u.from) / (patch.u.to - patch.u.from)};
    const Interval v{(piece.v.from - patch.v.from) / (patch.v.to - patch.v.from),
                     (piece.v.to - patch.v.from) / (patch.v.to - patch.v.from)};
    const Vector3d middle = patch.shape.at(0.5 * (u.from + u.to), 0.5 * (v.from + v.to));
    EXPECT_LE((piece.shape.at(0.5, 0.5) - middle).norm(), 1.0e-11);
  }
  EXPECT_EQ(area, (patch.u.to - patch.u.from) * (patch.v.to - patch.v.from));
}

TEST(PatchFlatness, PiecesAreFlatAndFewerByHalving) {
  std::size_t in_four = 0;
  std::size_t in_two = 0;
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(seed);
    proof::Random random{seed};
    const GridPatch patch{{3.0, 10.0}, {0.0, 5.0}, random_patch(random)};
    FlatnessLimit limit{.tolerance_mm = random.magnitude(0.05, 5.0),
                        .test = FlatnessTest::kBothOrders,
                        .slicing_normal = std::nullopt};
    const std::vector<GridPatch> quarters = quartered(patch, limit);
    const std::vector<GridPatch> halves = halved(patch, limit);
    check_pieces(patch, quarters, limit);
    check_pieces(patch, halves, limit);
    EXPECT_LE(halves.size(), quarters.size());
    in_four += quarters.size();
    in_two += halves.size();
    limit.slicing_normal = Vector3d::UnitX();
    check_pieces(patch, halved(patch, limit), limit);
  }
  if (trials.judges_shares()) {
    EXPECT_LE(static_cast<double>(in_two), 0.8 * static_cast<double>(in_four));
  }
}

}  // namespace
}  // namespace sim::surface::patch
