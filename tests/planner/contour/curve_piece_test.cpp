#include "planner/contour/curve_piece.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/planner/contour/test_curves.hpp"

namespace cnc::contour {
namespace {

constexpr double kFullCircle = 2.0 * std::numbers::pi;

std::vector<CurvePiece> divided(const PlaneCurve& curve,
                                double offset_mm,
                                double min_corner = kMinCorner) {
  std::vector<CurvePiece> pieces(64);
  const auto count = split_offset(curve, offset_mm, pieces, min_corner);
  EXPECT_TRUE(count.ok());
  pieces.resize(count.ok() ? count.value() : 0);
  return pieces;
}

/// Returns y = x² / 2 over −3…3, whose greatest curvature is 1, at the origin.
CurveJet parabola(double x) {
  return {.place = {x, 0.5 * x * x}, .first = {1.0, x}, .second = {0.0, 1.0}};
}

// κ d = −1 where (1 + x²)^1.5 = |d|. Between these points the offset runs backwards.
TEST(CurvePieces, AreDividedAtTheCuspsOfAParabolasOffset) {
  for (const std::size_t spans : {1U, 2U, 7U}) {
    const exact::FunctionCurve curve{parabola, -3.0, 3.0, spans};
    const auto pieces = divided(curve, -2.0);
    ASSERT_EQ(pieces.size(), 3U) << spans;
    const double cusp = std::sqrt(std::pow(2.0, 2.0 / 3.0) - 1.0);
    const double per_mm = static_cast<double>(spans) / 6.0;
    EXPECT_NEAR(pieces[0].to, (3.0 - cusp) * per_mm, 1.0e-7);
    EXPECT_NEAR(pieces[1].to, (3.0 + cusp) * per_mm, 1.0e-7);
    EXPECT_FALSE(pieces[0].backwards);
    EXPECT_TRUE(pieces[1].backwards);
    EXPECT_FALSE(pieces[2].backwards);
    EXPECT_EQ(pieces[2].to, static_cast<double>(spans));
  }
}

// At the vertex, κ d = −1.0000005 leaves two cusps 0.0012 mm apart.
TEST(CurvePieces, AreDividedAtTwoCuspsNearEachOther) {
  const exact::FunctionCurve curve{parabola, -3.0, 3.2, 1};
  EXPECT_EQ(divided(curve, -1.0000005).size(), 3U);
  EXPECT_EQ(divided(curve, -0.9999995).size(), 1U);
  EXPECT_EQ(divided(curve, 5.0).size(), 1U);
}

// An ellipse 2 a by 2 b has curvatures from b / a² to a / b².
TEST(CurvePieces, OfAnEllipsesOffsetInwardsAreFiveOrTurnedRound) {
  const EllipseCurve ellipse{
      {.major = {4.0, 0.0}, .minor = {0.0, 2.0}, .start = 0.5, .end = 0.5 + kFullCircle}};
  EXPECT_EQ(divided(ellipse, -0.999).size(), 1U);
  EXPECT_EQ(divided(ellipse, -3.0).size(), 5U);
  const auto beyond = divided(ellipse, -8.001);
  ASSERT_EQ(beyond.size(), 1U);
  EXPECT_TRUE(beyond.front().backwards);
}

TEST(CurvePieces, AreAtTheOffsetFromTheCurveAndRunAlongIt) {
  const EllipseCurve ellipse{{.major = {4.0, 0.0}, .minor = {0.0, 2.0}}};
  for (const double offset : {-3.0, -0.5, 0.0, 2.0}) {
    for (const CurvePiece& piece : divided(ellipse, offset)) {
      constexpr int kPlaces = 100;
      for (int i = 1; i < kPlaces; ++i) {
        const double spans = piece.from + (piece.to - piece.from) * i / kPlaces;
        const double angle = spans / 8.0 * kFullCircle;
        const WideVec2 source{4.0 * std::cos(angle), 2.0 * std::sin(angle)};
        const WayPoint point = piece.at(spans);
        EXPECT_NEAR((point.place - source).norm(), std::abs(offset), 1.0e-12);
        EXPECT_NEAR(point.tangent.dot(point.place - source), 0.0, 1.0e-12);
        const double step = 1.0e-6 * (piece.to - piece.from);
        EXPECT_GT((piece.at(spans + step).place - point.place).dot(point.tangent), 0.0);
      }
    }
  }
}

TEST(CurvePieces, AreDividedAtCornersBetweenSpansThatAreLargeEnough) {
  const auto bent = [](double bend) {
    return std::vector<WideVec2>{
        {0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {3.0, bend}, {4.0, 2.0 * bend}};
  };
  // A knot whose multiplicity is the degree is a corner at the middle point.
  const std::vector<double> knots{0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0};
  const exact::OwnedNurbs small{2, exact::OwnedNurbs::with_weights(bent(1.0e-3)), knots};
  const exact::OwnedNurbs large{2, exact::OwnedNurbs::with_weights(bent(0.1)), knots};
  EXPECT_EQ(divided(small.curve(), 0.0).size(), 2U);
  EXPECT_EQ(divided(small.curve(), 0.0, 0.01).size(), 1U);
  EXPECT_EQ(divided(large.curve(), 0.0, 0.01).size(), 2U);
  EXPECT_EQ(divided(large.curve(), 0.0).front().to, 1.0);
}

TEST(CurvePieces, SayWhenThereIsNoRoomOrNoDirection) {
  const EllipseCurve ellipse{{.major = {4.0, 0.0}, .minor = {0.0, 2.0}}};
  std::vector<CurvePiece> pieces(4);
  const auto full = split_offset(ellipse, -3.0, pieces);
  ASSERT_FALSE(full.ok());
  EXPECT_EQ(full.error(), SplitError::kTooManyPieces);
  const exact::FunctionCurve place{[](double /*t*/) { return CurveJet{}; }, 0.0, 1.0, 1};
  const auto none = split_offset(place, 0.0, pieces);
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.error(), SplitError::kNoDirection);
}

// If control points at an end coincide, the first derivative vanishes there.
TEST(CurvePieces, HaveTheTangentOfTheCurveWhereTheFirstDerivativeVanishes) {
  const exact::OwnedNurbs curve{3, {{0.0, 0.0}, {0.0, 0.0}, {3.0, 4.0}, {3.0, 4.0}}};
  const auto pieces = divided(curve.curve(), 0.0);
  ASSERT_EQ(pieces.size(), 1U);
  for (const double spans : {0.0, 0.5, 1.0}) {
    EXPECT_NEAR((pieces[0].at(spans).tangent - WideVec2{0.6, 0.8}).norm(), 0.0, 1.0e-12);
  }
}

}  // namespace
}  // namespace cnc::contour
