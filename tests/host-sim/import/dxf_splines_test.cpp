#include "host-sim/import/dxf_splines.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/host-sim/import/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::drawing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

std::string spline(int degree, const std::vector<double>& knots, const std::vector<Place>& points) {
  std::string text = fmt::format("0\nSPLINE\n8\n0\n71\n{}\n", degree);
  for (const double knot : knots) text += fmt::format("40\n{}\n", knot);
  for (const Place& point : points) text += fmt::format("10\n{}\n20\n{}\n", point.x(), point.y());
  return text;
}

Place bezier_at(const std::vector<Place>& p, double t) {
  const double s = 1.0 - t;
  return p[0] * (s * s * s) + p[1] * (3 * s * s * t) + p[2] * (3 * s * t * t) + p[3] * (t * t * t);
}

/// The knots are those of consecutive Béziers, each with separate end knots.
TEST(DxfSplines, AKnotOfDegreeAndOnePartsTheSpline) {
  const std::vector<Place> left{{0, 0}, {0, 10}, {10, 10}, {10, 0}};
  std::vector<Place> points = left;
  const std::vector<Place> right{{10, 0}, {10, -10}, {20, -10}, {20, 0}};
  points.insert(points.end(), right.begin(), right.end());
  const std::vector<double> knots{0, 0, 0, 0, 0.5, 0.5, 0.5, 0.5, 1, 1, 1, 1};
  const Drawing drawn = read(dxf_of(spline(3, knots, points)));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_THAT(shapes_of(drawn.contours[0]), ElementsAre("spline", "spline"));
  EXPECT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kOpen));
  for (const double t : {0.0, 0.3, 0.9, 1.0}) {
    const auto& shapes = drawn.contours[0].shapes;
    EXPECT_NEAR(distance(jet(shapes[0], 0, t).place, bezier_at(left, t)), 0.0, 1e-12);
    EXPECT_NEAR(distance(jet(shapes[1], 0, t).place, bezier_at(right, t)), 0.0, 1e-12);
  }
  // If the parts do not meet, they are separate contours.
  for (std::size_t i = 4; i < 8; ++i) points[i].x() += 5.0;
  EXPECT_THAT(read(dxf_of(spline(3, knots, points))).contours, SizeIs(2));
}

TEST(DxfSplines, EveryDegreeIsReadAndWhatIsWrongIsSaid) {
  const auto of_degree = [](int degree) {
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
    knots.resize(2 * knots.size(), 1.0);
    std::vector<Place> points;
    for (int i = 0; i <= degree; ++i) points.emplace_back(9.0 * i, i % 2);
    return read(dxf_of(spline(degree, knots, points)));
  };
  for (int degree = 1; degree <= 11; ++degree) {
    EXPECT_THAT(of_degree(degree).contours, SizeIs(1)) << degree;
  }
  EXPECT_THAT(of_degree(12).faults.at(0).reason, HasSubstr("degree is not from 1 to 11"));
  const auto wrong = [](int degree, const std::vector<double>& knots) {
    return read(dxf_of(spline(degree, knots, {{0, 0}, {5, 5}, {9, 0}}))).faults.at(0).reason;
  };
  EXPECT_THAT(wrong(2, {0, 0, 0, 1, 1}), HasSubstr("5 knots, but 3 control points"));
  EXPECT_THAT(wrong(2, {0, 0, 1, 0, 1, 1}), HasSubstr("knots are not in ascending order"));
  EXPECT_THAT(wrong(1, {0, 0, 0, 1, 1}), HasSubstr("more than 2 times"));
  EXPECT_THAT(wrong(3, {0, 0, 0, 0, 1, 1, 1}), HasSubstr("3 control points make no spline"));
}

/// Only the part between the inner knots is drawn.
TEST(DxfSplines, KnotsNeedNotBeClamped) {
  const Drawing drawn =
      read(dxf_of(spline(2, {0, 1, 2, 3, 4, 5, 6}, {{0, 0}, {10, 0}, {10, 10}, {0, 10}})));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_NEAR(distance(start_of(drawn.contours[0].shapes[0]), {5, 0}), 0.0, 1e-12);
  EXPECT_NEAR(distance(end_of(drawn.contours[0].shapes[0]), {5, 10}), 0.0, 1e-12);
}

TEST(DxfSplines, AHelixIsTheSplineThatItHolds) {
  const std::string helix =
      "0\nHELIX\n8\n0\n100\nAcDbSpline\n71\n1\n40\n0\n40\n0\n40\n1\n40\n1\n"
      "10\n0\n20\n0\n30\n0\n10\n9\n20\n0\n30\n4\n100\nAcDbHelix\n10\n5\n20\n5"
      "\n40\n3\n41\n2\n";
  const Drawing drawn = read(dxf_of(helix));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_NEAR(drawn.contours[0].length_mm, 9.0, 1e-9);
  EXPECT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kOpen, FaultKind::kNote));
}

/// Returns the jumps of the first and the second derivative from one shape to the next. The
/// parameters of the shapes are scaled by their chords, `left` and `right`.
std::pair<double, double> jumps(const Shape& before,
                                const Shape& after,
                                double left,
                                double right) {
  const Jet end = jet(before, 0, 1.0);
  const Jet start = jet(after, 0, 0.0);
  return {(end.first / left - start.first / right).norm(),
          (end.second / (left * left) - start.second / (right * right)).norm()};
}

TEST(DxfSplines, ClosedFitPointsAreSmoothAllRound) {
  for (const std::uint64_t seed : proof::Trials{100}) {
    proof::Random random{seed};
    const std::size_t count = 3 + random.below(12);
    std::vector<Place> places;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle =
          2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      places.emplace_back(direction(angle) * random.between(10.0, 40.0));
    }
    const std::vector<Shape> shapes = closed_spline(places);
    ASSERT_THAT(shapes, SizeIs(count)) << "KERFLINE_SEED=" << seed;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % count;
      EXPECT_EQ(start_of(shapes[i]), places[i]) << "KERFLINE_SEED=" << seed;
      const double left = distance(places[i], places[next]);
      const double right = distance(places[next], places[(next + 1) % count]);
      const auto [turn, bend] = jumps(shapes[i], shapes[next], left, right);
      EXPECT_LT(turn, 1e-9) << "KERFLINE_SEED=" << seed;
      EXPECT_LT(bend, 1e-9) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(DxfSplines, ClosedFitPointsOfAFileAreOneContour) {
  const Drawing drawn = read(dxf_of(
      "0\nSPLINE\n8\n0\n70\n1\n71\n3\n11\n0\n21\n0\n11\n9\n21\n0\n11\n9\n21\n9\n11\n0\n21\n0\n"));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_TRUE(drawn.contours[0].closed);
  EXPECT_THAT(drawn.contours[0].shapes, SizeIs(3));
  EXPECT_THAT(drawn.faults, IsEmpty());
}

}  // namespace
}  // namespace sim::drawing
