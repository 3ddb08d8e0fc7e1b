#include "host-sim/wall/path/stroke_tracer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/host-sim/wall/degrees.hpp"
#include "tests/host-sim/wall/solids.hpp"
#include "tests/support/trials.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kHalfAngle = 7.0 * kDegree;

BeamRules beam_rules() {
  return {.tilt = {.half_angle_rad = kHalfAngle, .max_rad = 45.0 * kDegree}};
}

/// Returns the greatest depth of a beam in the facets of a part, found by trying each facet. Facets
/// through the tip count from the tip on.
double depth_in(const surface::Mesh& mesh, const TipBeam& tip_beam) {
  const Beam beam = Beam::along(tip_beam.tip, tip_beam.axis, kHalfAngle, 1.0e4);
  double depth = -1.0e9;
  for (const auto& [a, b, c] : mesh.facets) {
    const Triangle facet{mesh.points[a], mesh.points[b], mesh.points[c]};
    depth = std::max(depth, -cnc::wall::clearance(beam, as_obstacle(facet, beam.tip)));
  }
  return depth;
}

double angle_between(const Vector3d& one, const Vector3d& other) {
  return std::atan2(one.cross(other).norm(), one.dot(other));
}

/// Checks beams and interpolated beams, and how fast they turn.
void expect_clear_and_slow(const surface::Mesh& mesh,
                           const std::vector<BeamRun>& runs,
                           const TurnRules& rules) {
  for (const BeamRun& run : runs) {
    ASSERT_NE(run.beams.size(), 1U);
    for (std::size_t i = 0; i < run.beams.size(); ++i) {
      EXPECT_LE(depth_in(mesh, run.beams[i]), 1.0e-8);
      if (i == 0) continue;
      const TipBeam& last = run.beams[i - 1];
      const TipBeam& next = run.beams[i];
      const double length = (next.tip - last.tip).norm();
      // If there is no space to turn in time, tips are close together.
      const double angle = angle_between(last.axis, next.axis);
      EXPECT_TRUE(angle <= rules.turn_rate_rad_per_mm * length + 1e-8 ||
                  (length <= StrokeTracer::kGapMm && angle <= rules.swing_rad))
          << angle << " in " << length;
      RotaryWords from = first_words_of(rules.axes, last.axis);
      if (from.tilt == 0.0) from.turn = first_words_of(rules.axes, next.axis).turn;
      const RotaryWords to = words_of(rules.axes, next.axis, from);
      for (const double share : {0.25, 0.5, 0.75}) {
        const RotaryWords words{from.tilt + share * (to.tilt - from.tilt),
                                from.turn + share * (to.turn - from.turn)};
        const TipBeam between{.tip = last.tip + share * (next.tip - last.tip),
                              .axis = axis_of(rules.axes, words)};
        EXPECT_LE(depth_in(mesh, between), 1.5 * rules.depth_mm) << share;
      }
    }
  }
}

TEST(RotaryWords, AreThoseOfTheAxisAndNearTheLast) {
  const proof::Trials trials{100'000};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const auto axes = random.chance(0.5) ? RotaryAxes::kAC : RotaryAxes::kBC;
    const double tilt = random.between(0.001, 80.0);
    const double turn = random.between(-180.0, 180.0);
    const Vector3d axis = axis_of(axes, {tilt, turn});
    const RotaryWords last{random.between(-80.0, 80.0), random.between(-2000.0, 2000.0)};
    const RotaryWords words = words_of(axes, axis, last);
    EXPECT_NEAR((axis_of(axes, words) - axis).norm(), 0.0, 1.0e-12) << seed;
    EXPECT_NEAR(std::abs(words.tilt), tilt, 1.0e-9) << seed;
    EXPECT_LE(std::abs(words.turn - last.turn), 180.0 + 1.0e-9) << seed;
    const RotaryWords first = first_words_of(axes, axis);
    EXPECT_NEAR(first.tilt, tilt, 1.0e-9) << seed;
    EXPECT_NEAR(first.turn, turn, 1.0e-6) << seed;
  }
}

TEST(RotaryWords, OfAnUprightAxisKeepC) {
  EXPECT_EQ(words_of(RotaryAxes::kAC, Vector3d::UnitZ(), {3.0, 77.0}).turn, 77.0);
  // When the axis passes through the vertical to the other side, C stays and the tilt changes its
  // sign.
  const RotaryWords over = words_of(RotaryAxes::kAC, axis_of(RotaryAxes::kAC, {2, 190}), {1, 10});
  EXPECT_NEAR(over.tilt, -2.0, 1e-9);
  EXPECT_NEAR(over.turn, 10.0, 1e-9);
}

TEST(StrokeTracer, LeansInTimeBesideAWall) {
  const surface::Mesh mesh = pocket_solid(4, 8, 2);
  const Obstacles obstacles{mesh};
  const TurnRules rules{.step_mm = 0.1, .turn_rate_rad_per_mm = 20.0 * kDegree};
  const StrokeTracer tracer{{obstacles, beam_rules()}, rules};
  // At the first layer, the wall above the tip is so low that the least tilt changes within 2 um.
  for (const double height : {1.99, 1.0, 0.0}) {
    const auto runs = tracer.runs_of({StrokeUse::kHatch, {{-2, 0.3}, {2, 0.3}}}, height);
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_TRUE(runs.front().lost.empty());
    EXPECT_NEAR(tilt_of({.axis = runs.front().beams.front().axis}), kHalfAngle, 1e-9);
    EXPECT_NEAR(tilt_of({.axis = runs.front().beams.back().axis}), kHalfAngle, 1e-9);
    expect_clear_and_slow(mesh, runs, rules);
  }
}

TEST(StrokeTracer, GoesAroundAPocketInOneRunAndInItsCornersLeansFromBothWalls) {
  const surface::Mesh mesh = pocket_solid(4, 8, 2);
  const Obstacles obstacles{mesh};
  const TurnRules rules{.step_mm = 0.1, .turn_rate_rad_per_mm = 45.0 * kDegree};
  const StrokeTracer tracer{{obstacles, beam_rules()}, rules};
  for (const double height : {1.99, 1.0, 0.0}) {
    const auto runs = tracer.runs_of(
        {StrokeUse::kContour, {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}, {-2, -2}}}, height);
    ASSERT_EQ(runs.size(), 1U);
    EXPECT_NEAR(tilt_of({.axis = runs.front().beams.front().axis}) / kDegree, 9.925, 1e-3);
    expect_clear_and_slow(mesh, runs, rules);
  }
}

TEST(StrokeTracer, SwingsTheBeamAtConvexCornersWhileItIsOff) {
  const surface::Mesh mesh = prism_solid({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0, 2);
  const Obstacles obstacles{mesh};
  const Stroke around{StrokeUse::kContour, {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {-1, -1}}};
  TurnRules rules{.step_mm = 0.1, .turn_rate_rad_per_mm = 45.0 * kDegree};
  rules.swing_rad = 180.0 * kDegree;
  const auto turned = StrokeTracer{{obstacles, beam_rules()}, rules}.runs_of(around, 1.0);
  EXPECT_EQ(turned.size(), 1U);
  expect_clear_and_slow(mesh, turned, rules);
  rules.swing_rad = 3.0 * kDegree;
  const auto runs = StrokeTracer{{obstacles, beam_rules()}, rules}.runs_of(around, 1.0);
  ASSERT_GE(runs.size(), 4U);
  expect_clear_and_slow(mesh, runs, rules);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_TRUE(runs[i].lost.empty());
    if (i == 0) continue;
    const double gap = (runs[i].beams.front().tip - runs[i - 1].beams.back().tip).norm();
    EXPECT_LE(gap, 2.0 * StrokeTracer::kGapMm);
  }
}

TEST(StrokeTracer, ListsTipsThatNoAxisReaches) {
  const surface::Mesh mesh = pocket_solid(0.1, 8, 2);
  const Obstacles obstacles{mesh};
  const StrokeTracer tracer{{obstacles, beam_rules()},
                            {.step_mm = 0.1, .turn_rate_rad_per_mm = 45.0 * kDegree}};
  const auto runs = tracer.runs_of({StrokeUse::kHatch, {{-0.05, 0}, {0.05, 0}}}, 0.0);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_TRUE(runs.front().beams.empty());
  EXPECT_GE(runs.front().lost.size(), 2U);
}

TEST(StrokeTracer, KeepsClearAndSlowOnRandomLinesBesideRandomPrisms) {
  const proof::Trials trials{400};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    std::vector<Vector2d> polygon;
    const std::size_t corners = 3 + random.below(6);
    for (std::size_t i = 0; i < corners; ++i) {
      const double turn =
          2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
      polygon.emplace_back(2.0 * std::cos(turn + 0.1), 2.0 * std::sin(turn + 0.1));
    }
    const surface::Mesh mesh = prism_solid(polygon, -1.0, random.between(0.01, 3.0));
    const Obstacles obstacles{mesh};
    const TurnRules rules{.axes = random.chance(0.5) ? RotaryAxes::kAC : RotaryAxes::kBC,
                          .step_mm = random.magnitude(0.02, 0.5),
                          .turn_rate_rad_per_mm = random.magnitude(10.0, 300.0) * kDegree};
    const StrokeTracer tracer{{obstacles, beam_rules()}, rules};
    // The stroke runs from the middle of a wall away from it, or along a wall.
    const std::size_t side = random.below(corners);
    const Vector2d from = polygon[side];
    const Vector2d to = polygon[(side + 1) % corners];
    const Vector2d on_wall = from + random.unit() * (to - from);
    const Vector2d along = (to - from).normalized();
    const Vector2d out{along.y(), -along.x()};
    const Vector2d goal =
        random.chance(0.5)
            ? Vector2d{on_wall + random.between(0.01, 2.0) * out + random.between(-2, 2) * along}
            : to;
    if ((goal - on_wall).norm() < 0.01) continue;
    const auto runs = tracer.runs_of({StrokeUse::kHatch, {on_wall, goal}}, 0.0);
    expect_clear_and_slow(mesh, runs, rules);
    for (const BeamRun& run : runs) EXPECT_TRUE(run.lost.empty());
    if (proof::too_many_failures()) break;
  }
}

}  // namespace
}  // namespace sim::wall
