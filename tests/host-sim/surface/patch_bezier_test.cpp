#include <gtest/gtest.h>

#include "host-sim/surface/patch/bezier_patch.hpp"
#include "tests/host-sim/surface/patch_support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

TEST(PatchBezier, DerivativesAreThoseOfThePoints) {
  for (const std::uint64_t seed : proof::Trials{2000}) {
    proof::Random random{seed};
    const BezierPatch patch = random_patch(random);
    const double u = random.between(0.1, 0.9);
    const double v = random.between(0.1, 0.9);
    constexpr double kStep = 1.0e-4;
    const PatchJet jet = patch.jet(u, v);
    const Vector3d along_u = (patch.at(u + kStep, v) - patch.at(u - kStep, v)) / (2.0 * kStep);
    const Vector3d along_v = (patch.at(u, v + kStep) - patch.at(u, v - kStep)) / (2.0 * kStep);
    const Vector3d twist =
        (patch.jet(u, v + kStep).along_u - patch.jet(u, v - kStep).along_u) / (2.0 * kStep);
    EXPECT_LE((jet.point - patch.at(u, v)).norm(), 1.0e-12) << "KERFLINE_SEED=" << seed;
    EXPECT_LE((jet.along_u - along_u).norm(), 1.0e-4) << "KERFLINE_SEED=" << seed;
    EXPECT_LE((jet.along_v - along_v).norm(), 1.0e-4) << "KERFLINE_SEED=" << seed;
    EXPECT_LE((jet.twist - twist).norm(), 1.0e-4) << "KERFLINE_SEED=" << seed;
  }
}

TEST(PatchBezier, PartsAreTheSameSurface) {
  for (const std::uint64_t seed : proof::Trials{2000}) {
    proof::Random random{seed};
    const BezierPatch patch = random_patch(random);
    const Interval u{random.between(0.0, 0.4), random.between(0.6, 1.0)};
    const Interval v{random.between(0.0, 0.4), random.between(0.6, 1.0)};
    const BezierPatch part = patch.part(u, v);
    for (int i = 0; i < 10; ++i) {
      const double s = random.unit();
      const double t = random.unit();
      const Vector3d whole = patch.at(u.from + s * (u.to - u.from), v.from + t * (v.to - v.from));
      EXPECT_LE((part.at(s, t) - whole).norm(), 1.0e-12) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(PatchBezier, NeighbourPartsShareTheirBorderToTheLastBit) {
  for (const std::uint64_t seed : proof::Trials{2000}) {
    proof::Random random{seed};
    const BezierPatch patch = random_patch(random);
    const double border = random.unit();
    const Interval v{random.between(0.0, 0.4), random.between(0.6, 1.0)};
    const BezierPatch before = patch.part({0.0, border}, v);
    const BezierPatch behind = patch.part({border, 1.0}, v);
    const BezierPatch left = patch.part(v, {0.0, border});
    const BezierPatch right = patch.part(v, {border, 1.0});
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(before.control(3, i), behind.control(0, i)) << "KERFLINE_SEED=" << seed;
      EXPECT_EQ(left.control(i, 3), right.control(i, 0)) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(PatchBezier, CurvesOfPatchesAreItsPoints) {
  for (const std::uint64_t seed : proof::Trials{500}) {
    proof::Random random{seed};
    const BezierPatch patch = random_patch(random);
    const double u = random.unit();
    const double v = random.unit();
    EXPECT_LE((patch.curve_at_u(u).at(v) - patch.at(u, v)).norm(), 1.0e-12);
    EXPECT_LE((patch.curve_at_v(v).at(u) - patch.at(u, v)).norm(), 1.0e-12);
    EXPECT_EQ(patch.at(0.0, 0.0), patch.control(0, 0));
    EXPECT_EQ(patch.at(1.0, 0.0), patch.control(3, 0));
  }
}

}  // namespace
}  // namespace sim::surface::patch
