#include "host-sim/pocket/round_return.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::Crescent;
using cnc::pocket::ToolCircle;
using sim::pocket::DepthWriter;
using sim::pocket::PathRows;

WideVec2 on_circle(const ToolCircle& circle, double angle) {
  return circle.centre + circle.radius * WideVec2{std::cos(angle), std::sin(angle)};
}

/// A tool at the end of a cut along a circle, and the next circle. The tool returns to the
/// beginning of the crescent between the two circles.
struct Return {
  PathRows rows;
  DepthWriter writer{rows, 1.0};
  ToolCircle disc{{0.0, 0.0}, 10.0};
  Crescent crescent;

  Return(const ToolCircle& next, double cut_end) : crescent{crescent_between(disc, next)} {
    writer.begin_row_in_cleared(on_circle(disc, cut_end - 1.0));
    writer.pass(on_circle(disc, cut_end), std::tan(0.25));
    const WideVec2 outwards = (crescent.begin - next.centre) / next.radius;
    go_back_round(writer, disc, {crescent.begin, cnc::left_normal(outwards)}, 2.0);
    writer.light_pass(crescent.middle, crescent.bulge);
  }

  /// Returns point `i`, counted from the last point of the cut.
  [[nodiscard]] const cnc::pocket::PathPoint<double>& point(std::size_t i) const {
    return rows.points[i + 1];
  }
  [[nodiscard]] std::size_t count() const { return rows.points.size() - 1; }
};

TEST(RoundReturns, HaveOneTangentAndStayInTheDisc) {
  for (const std::uint64_t seed : Trials{2000}) {
    Random random{seed};
    const double ahead = random.between(-3.1, 3.1);
    const ToolCircle next{random.between(1.0, 4.0) * WideVec2{std::cos(ahead), std::sin(ahead)},
                          random.between(8.5, 11.0)};
    const Return way{next, ahead + random.between(0.5, 1.5) * 0.5 * std::numbers::pi};
    if (!way.crescent.exists) continue;
    ASSERT_GE(way.count(), 6U) << "KERFLINE_SEED=" << seed;
    for (std::size_t i = 0; i + 2 < way.count(); ++i) {
      const auto& from = way.point(i);
      const auto& to = way.point(i + 1);
      EXPECT_LT(cnc::pocket::kink_between(from, to, way.point(i + 2)), 1.0e-6);
      if (i + 3 == way.count()) continue;
      const cnc::contour::exact::PlainArc arc{cnc::pocket::arc_of(from, to)};
      for (const double share : {0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
        EXPECT_LE((arc.at(share) - way.disc.centre).norm(), way.disc.radius + 1.0e-8);
      }
    }
  }
}

TEST(RoundReturns, DoNotLeaveAPlaceWhereTheCutBegins) {
  PathRows rows;
  DepthWriter writer{rows, 1.0};
  const ToolCircle disc{{3.0, 4.0}, 2.0};
  writer.begin_row_in_cleared(disc.centre);
  const std::size_t points = rows.points.size();
  go_back_round(writer, disc, {disc.centre, {0.0, 1.0}}, 0.5);
  EXPECT_EQ(rows.points.size(), points);
}

double outside(const std::vector<ToolCircle>& discs, const WideVec2& place) {
  double least = INFINITY;
  for (const ToolCircle& disc : discs) {
    least = std::min(least, (place - disc.centre).norm() - disc.radius);
  }
  return least;
}

TEST(RoundReturns, StayInTheDiscsThatTheyLeadThrough) {
  std::size_t corners = 0;
  std::size_t joints = 0;
  for (const std::uint64_t seed : Trials{2000}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    std::vector<ToolCircle> discs{{{0.0, 0.0}, random.between(0.5, 5.0)}};
    double ahead = random.between(-3.1, 3.1);
    while (discs.size() < 8) {
      const ToolCircle& last = discs.back();
      const double radius = last.radius * random.between(0.8, 1.2);
      ahead += random.between(-0.5, 0.5);
      const double way = random.between(0.05, 0.9) * (last.radius + radius);
      discs.push_back({on_circle({last.centre, way}, ahead), radius});
    }
    PathRows rows;
    DepthWriter writer{rows, 1.0};
    const double start = random.between(-3.1, 3.1);
    writer.begin_row_in_cleared(on_circle(discs.front(), start - 1.0));
    writer.pass(on_circle(discs.front(), start), std::tan(0.25));
    go_through_round(writer, discs, random.between(0.1, 1.0));
    EXPECT_LT((writer.place() - discs.back().centre).norm(), 1.0e-9);
    for (std::size_t i = 2; i + 1 < rows.points.size(); ++i) {
      const cnc::contour::exact::PlainArc arc{
          cnc::pocket::arc_of(rows.points[i], rows.points[i + 1])};
      for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
        ASSERT_LE(outside(discs, arc.at(share)), 1.0e-8);
      }
      ++joints;
      const double kink =
          cnc::pocket::kink_between(rows.points[i - 1], rows.points[i], rows.points[i + 1]);
      if (kink > 1.0e-3) ++corners;
    }
  }
  // Corners are allowed where the path almost reverses, and where the first arc has no space.
  EXPECT_LT(20 * corners, joints);
}

/// Expects that the elements of a path from `first` on meet with a common tangent.
void expect_smooth(const PathRows& rows, std::size_t first) {
  for (std::size_t i = first; i + 1 < rows.points.size(); ++i) {
    EXPECT_LT(cnc::pocket::kink_between(rows.points[i - 1], rows.points[i], rows.points[i + 1]),
              1.0e-6);
  }
}

TEST(RoundReturns, TurnOnceWhereTwoDiscsHaveOneCentre) {
  const std::vector<ToolCircle> discs{
      {{0.0, 0.0}, 4.0}, {{4.0, 0.0}, 2.0}, {{4.0 + 3.0e-8, 0.0}, 2.0}, {{4.0, 5.0}, 3.0}};
  PathRows rows;
  DepthWriter writer{rows, 1.0};
  writer.begin_row_in_cleared({-2.0, 0.0});
  writer.pass({-1.0, 0.0}, 0.0);
  go_through_round(writer, discs, 0.5);
  EXPECT_LT((writer.place() - discs.back().centre).norm(), 1.0e-9);
  const auto& points = rows.points;
  ASSERT_GE(points.size(), 6U);
  for (std::size_t i = 2; i + 1 < points.size(); ++i) {
    EXPECT_LT(cnc::pocket::kink_between(points[i - 1], points[i], points[i + 1]), 1.0e-5);
  }
}

TEST(RoundReturns, HaveSmallerTurnsWhereLargeOnesWouldLeaveTheDisc) {
  PathRows rows;
  DepthWriter writer{rows, 1.0};
  writer.begin_row_in_cleared({-3.0, 0.0});
  writer.pass({-1.0, 0.0});
  // A left turn of 2 mm does not fit into a circle of 1 mm.
  go_back_round(writer, {{0.0, 0.0}, 1.0}, {{0.0, 1.0}, {-1.0, 0.0}}, 2.0);
  expect_smooth(rows, 2);
  EXPECT_GT(rows.points.size(), 4U);
  for (std::size_t i = 2; i + 1 < rows.points.size(); ++i) {
    EXPECT_LE(rows.points[i].point().norm(), 1.0 + 1.0e-8);
    EXPECT_EQ(rows.points[i].use, cnc::pocket::Use::kReturn);
  }
}

TEST(RoundReturns, TurnToEitherSide) {
  PathRows rows;
  DepthWriter writer{rows, 1.0};
  writer.begin_row_in_cleared({-3.0, 0.0});
  writer.pass({-1.0, 0.0});
  go_back_round(writer, {{0.0, 0.0}, 10.0}, {{9.0, -1.0}, {1.0, 0.0}}, 2.0);
  expect_smooth(rows, 2);
  EXPECT_LT(rows.points[2].bulge, 0.0) << "to the right";
  EXPECT_GT(rows.points[4].bulge, 0.0) << "to the left";
}

TEST(RoundReturns, SetOffStraightAfterADescent) {
  PathRows rows;
  DepthWriter writer{rows, 1.0};
  writer.begin_row_in_cleared({-1.0, 0.0});
  go_back_round(writer, {{0.0, 0.0}, 10.0}, {{0.0, 10.0}, {-1.0, 0.0}}, 2.0);
  expect_smooth(rows, 2);
  EXPECT_EQ(rows.points.back().point(), (WideVec2{0.0, 10.0}));
}

}  // namespace
}  // namespace proof
