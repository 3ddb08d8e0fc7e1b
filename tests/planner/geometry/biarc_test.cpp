#include "planner/geometry/biarc.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

constexpr double kPiExact = std::numbers::pi;

Vec2 unit(double angle) {
  return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}
double angle_of(const Vec2& v) {
  return std::atan2(static_cast<double>(v.y()), static_cast<double>(v.x()));
}
double turn(double from, double to) { return std::remainder(to - from, 2.0 * kPiExact); }

/// Returns the direction of an arc at its start, from its chord and bulge; arriving(), at its end.
double leaving(const Vec2& chord, float bulge) {
  return angle_of(chord) - 2.0 * std::atan(static_cast<double>(bulge));
}
double arriving(const Vec2& chord, float bulge) {
  return angle_of(chord) + 2.0 * std::atan(static_cast<double>(bulge));
}

struct Worst {
  double tangent = 0.0;
  double joint = 0.0;
};

/// Checks the tangents at both ends and at the joint, and that the joint is on its circle.
void check(const BiarcEnds& ends, float share, const Biarc& biarc, Worst& worst) {
  const Vec2 first = biarc.joint - ends.start;
  const Vec2 second = ends.end - biarc.joint;
  const double size = static_cast<double>((ends.end - ends.start).norm());
  const double joint = angle_of(biarc.joint_tangent);
  // The directions of chords that are much shorter than the complete biarc have lost digits.
  const double least = static_cast<double>(std::min(first.norm(), second.norm())) / size;
  const double room = std::min(1.0, least);
  worst.tangent = std::max(
      {worst.tangent,
       room * std::abs(turn(leaving(first, biarc.first_bulge), angle_of(ends.start_tangent))),
       room * std::abs(turn(arriving(first, biarc.first_bulge), joint)),
       room * std::abs(turn(leaving(second, biarc.second_bulge), joint)),
       room * std::abs(turn(arriving(second, biarc.second_bulge), angle_of(ends.end_tangent)))});
  const double chord = angle_of(ends.end - ends.start);
  const double a = turn(chord, angle_of(ends.start_tangent));
  const double b = turn(chord, angle_of(ends.end_tangent));
  const double w = 0.5 * (b - a);
  const double s = static_cast<double>(share);
  const double part = std::abs(w) < 1.0e-9 ? s : std::sin(s * w) / std::sin(w);
  const double direction = chord - (1.0 - s) * w;
  const double x = static_cast<double>(first.x()) - size * part * std::cos(direction);
  const double y = static_cast<double>(first.y()) - size * part * std::sin(direction);
  worst.joint = std::max(worst.joint, std::hypot(x, y) / (size * std::max(1.0, part)));
}

TEST(Biarc, MeetsBothTangentsForEveryShapeAndJoint) {
  const proof::Trials trials{200'000};
  Worst worst;
  std::size_t made = 0;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const double size = random.magnitude(1.0e-3, 1.0e3);
    const double direction = random.between(-kPiExact, kPiExact);
    const double spread = random.chance(0.5) ? 2.5 : random.magnitude(1.0e-6, 1.0);
    const double a = random.between(-spread, spread);
    const double b = random.chance(0.1) ? a : random.between(-spread, spread);
    const BiarcEnds ends{.start = {0.0F, 0.0F},
                         .start_tangent = unit(direction + a),
                         .end = static_cast<float>(size) * unit(direction),
                         .end_tangent = unit(direction + b)};
    const auto share = static_cast<float>(random.between(0.05, 0.95));
    const auto biarc = make_biarc(ends, share);
    if (!biarc.ok()) {
      const double w = 0.5 * (b - a);
      const double most = std::max(std::abs(-a - (1.0 - static_cast<double>(share)) * w),
                                   std::abs(b - static_cast<double>(share) * w));
      ASSERT_GT(most, 0.5 * kPiExact - 1.0e-5) << "KERFLINE_SEED=" << seed;
      continue;
    }
    ++made;
    check(ends, share, biarc.value(), worst);
    ASSERT_LE(worst.tangent, kBiarcTangentError) << "KERFLINE_SEED=" << seed;
    ASSERT_LE(worst.joint, kBiarcJointError) << "KERFLINE_SEED=" << seed;
  }
  std::printf(
      "biarcs: %zu, tangent error %.2e, joint error %.2e\n", made, worst.tangent, worst.joint);
}

// Tests the same routine in double precision with its own bound. An arc with a given bulge leaves
// its start at an angle of 2 atan(bulge) before its chord.
TEST(BiarcInDouble, MeetsBothTangentsForEveryShapeAndJoint) {
  const proof::Trials trials{200'000};
  double worst = 0.0;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const double size = random.magnitude(1.0e-3, 1.0e3);
    const double spread = random.chance(0.5) ? 2.5 : random.magnitude(1.0e-9, 1.0);
    const double chord = random.between(-kPiExact, kPiExact);
    const double from = chord + random.between(-spread, spread);
    const double to = chord + random.between(-spread, spread);
    const auto direction = [](double angle) { return WideVec2{std::cos(angle), std::sin(angle)}; };
    const WideBiarcEnds ends{{0.0, 0.0}, direction(from), size * direction(chord), direction(to)};
    const auto made = make_biarc(ends, random.between(0.05, 0.95));
    if (!made.ok()) continue;
    const auto angle = [](const WideVec2& v) { return std::atan2(v.y(), v.x()); };
    const WideBiarc& biarc = made.value();
    const WideVec2 first = biarc.joint - ends.start;
    const WideVec2 second = ends.end - biarc.joint;
    const double room = std::min({1.0, first.norm() / size, second.norm() / size});
    const double joint = angle(biarc.joint_tangent);
    const double a = 2.0 * std::atan(biarc.first_bulge);
    const double b = 2.0 * std::atan(biarc.second_bulge);
    worst = std::max({worst,
                      room * std::abs(turn(angle(first) - a, from)),
                      room * std::abs(turn(angle(first) + a, joint)),
                      room * std::abs(turn(angle(second) - b, joint)),
                      room * std::abs(turn(angle(second) + b, to))});
    ASSERT_LE(worst, kWideBiarcError) << "KERFLINE_SEED=" << seed;
  }
  std::printf("biarcs in double precision: tangent error %.2e\n", worst);
}

TEST(Biarc, IsALineBetweenTangentsAlongTheChord) {
  const auto biarc = make_biarc({{1.0F, 2.0F}, {1.0F, 0.0F}, {5.0F, 2.0F}, {1.0F, 0.0F}}, 0.25F);
  ASSERT_TRUE(biarc.ok());
  EXPECT_EQ(biarc.value().first_bulge, 0.0F);
  EXPECT_EQ(biarc.value().second_bulge, 0.0F);
  EXPECT_FLOAT_EQ(biarc.value().joint.x(), 2.0F);
  EXPECT_FLOAT_EQ(biarc.value().joint.y(), 2.0F);
}

// The tangents are those of one circle, and both halves lie on it.
TEST(Biarc, IsTheArcItselfWhereOneWouldDo) {
  const auto biarc = make_biarc({{1.0F, 0.0F}, {0.0F, 1.0F}, {-1.0F, 0.0F}, {0.0F, -1.0F}}, 0.5F);
  ASSERT_TRUE(biarc.ok());
  EXPECT_NEAR(static_cast<double>(biarc.value().joint.norm()), 1.0, 1.0e-6);
  EXPECT_NEAR(static_cast<double>(biarc.value().first_bulge), std::tan(kPiExact / 8.0), 1.0e-6);
  EXPECT_NEAR(static_cast<double>(biarc.value().second_bulge), std::tan(kPiExact / 8.0), 1.0e-6);
}

// An S between parallel tangents, for which formulas that divide by the difference of the tangents
// fail. The halves are mirrored at the middle.
TEST(Biarc, JoinsParallelTangents) {
  const auto biarc = make_biarc({{0.0F, 0.0F}, {1.0F, 0.0F}, {2.0F, 1.0F}, {1.0F, 0.0F}}, 0.5F);
  ASSERT_TRUE(biarc.ok());
  EXPECT_FLOAT_EQ(biarc.value().joint.x(), 1.0F);
  EXPECT_FLOAT_EQ(biarc.value().joint.y(), 0.5F);
  EXPECT_FLOAT_EQ(biarc.value().first_bulge, -biarc.value().second_bulge);
}

TEST(Biarc, IsRefusedWhereThereIsNone) {
  const Vec2 ahead{1.0F, 0.0F};
  const auto point = make_biarc({{3.0F, 3.0F}, ahead, {3.0F, 3.0F}, ahead}, 0.5F);
  ASSERT_FALSE(point.ok());
  EXPECT_EQ(point.error(), BiarcError::kChordTooShort);
  // The path runs backwards at both ends: more than half a turn, for any joint.
  const auto back = make_biarc({{0.0F, 0.0F}, {-1.0F, 0.0F}, {1.0F, 0.0F}, {-1.0F, 0.0F}}, 0.5F);
  ASSERT_FALSE(back.ok());
  EXPECT_EQ(back.error(), BiarcError::kSweepTooLarge);
}

TEST(Biarc, BulgesOfAnArcFollowFromItsTangents) {
  for (double half = -1.57; half < 1.57; half += 0.01) {
    const auto want = static_cast<float>(std::tan(0.5 * half));
    EXPECT_NEAR(bulge_between(unit(0.3), 7.0F * unit(0.3 + half)), want, 1.0e-6) << half;
    EXPECT_NEAR(bulge_between(7.0F * unit(0.3), unit(0.3 + half)), want, 1.0e-6) << half;
  }
  EXPECT_EQ(bulge_between({1.0F, 0.0F}, {0.0F, 0.0F}), 0.0F);
}

}  // namespace
}  // namespace cnc
