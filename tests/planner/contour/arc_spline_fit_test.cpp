#include "planner/contour/arc_spline_fit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "tests/planner/contour/exact_distance.hpp"
#include "tests/planner/contour/test_curves.hpp"
#include "tests/support/trials.hpp"

namespace cnc::contour {
namespace {

using exact::BothWays;
using exact::ChainArc;

class ArcSplineFit : public testing::Test {
 protected:
  Result<std::size_t, FitError> fit(const CurvePiece& piece, const FitOptions& options) {
    return fit_arcs(piece, options, {samples_, links_}, vertices_);
  }
  [[nodiscard]] std::vector<ChainArc> chain(std::size_t count) const {
    return exact::arcs_between(std::span{vertices_}.first(count + 1));
  }
  std::vector<CurvePiece> pieces_of(const PlaneCurve& curve, double offset_mm) {
    std::vector<CurvePiece> pieces(64);
    const auto count = split_offset(curve, offset_mm, pieces);
    EXPECT_TRUE(count.ok());
    pieces.resize(count.ok() ? count.value() : 0);
    return pieces;
  }

  /// Returns the greatest angle in degrees by which the rounding of its ends rotates an arc that is
  /// too short for its coordinates; 0 for longer arcs.
  static double unrepresented(const ChainArc& arc) {
    constexpr double kLongEnough = 1.0e-4;
    const double chord = (arc.end - arc.start).norm();
    if (chord >= kLongEnough) return 0.0;
    constexpr double kBits = 4.0 * std::numeric_limits<double>::epsilon();
    return kBits * arc.start.cwiseAbs().maxCoeff() / chord * 180.0 / std::numbers::pi;
  }
  /// Returns the sum of these angles. They accumulate, as each arc begins in the direction in which
  /// the one before ends.
  static double unrepresented(std::span<const ChainArc> chain) {
    double sum = 0.0;
    for (const ChainArc& arc : chain) sum += 2.0 * unrepresented(arc);
    return sum;
  }
  void expect_smooth(std::span<const ChainArc> chain) const {
    for (std::size_t i = 1; i < chain.size(); ++i) {
      ASSERT_EQ(chain[i - 1].end, chain[i].start) << i;
      const double kink =
          BothWays::kink(BothWays::arriving(chain[i - 1]), BothWays::leaving(chain[i]));
      ASSERT_LE(kink, kLargestKinkDegrees + unrepresented(chain[i - 1]) + unrepresented(chain[i]))
          << i << " of " << chain.size();
    }
  }
  void expect_ends(const CurvePiece& piece,
                   const FitOptions& options,
                   std::span<const ChainArc> chain) const {
    const WayPoint start = piece.at(piece.from);
    const WayPoint end = piece.at(piece.to);
    if (options.start != FitEnd::kFree) {
      ASSERT_EQ(chain.front().start, start.place);
    }
    if (options.end != FitEnd::kFree) {
      ASSERT_EQ(chain.back().end, end.place);
    }
    if (options.start == FitEnd::kTangent) {
      ASSERT_LE(BothWays::kink(BothWays::leaving(chain.front()), angle(start.tangent)),
                kLargestKinkDegrees + unrepresented(chain.front()));
    }
    if (options.end == FitEnd::kTangent) {
      ASSERT_LE(BothWays::kink(BothWays::arriving(chain.back()), angle(end.tangent)),
                kLargestKinkDegrees + unrepresented(chain));
    }
  }
  void expect_near(const CurvePiece& piece, double tolerance, std::span<const ChainArc> chain) {
    const BothWays distance{piece, chain, tolerance};
    const double there = distance.curve_to_chain() / tolerance;
    const double back = distance.chain_to_curve() / tolerance;
    ASSERT_LE(there, 1.0 + 1.0e-7);
    ASSERT_LE(back, 1.0 + 1.0e-7 + distance.fine() / tolerance);
    worst_ = std::max({worst_, there, back});
  }

  static double angle(const WideVec2& v) {
    return std::atan2(v.y(), v.x()) * 180.0 / std::numbers::pi;
  }

  static constexpr double kLargestKinkDegrees = 1.0e-6;

  double worst_ = 0.0;
  std::vector<CurveSample> samples_ = std::vector<CurveSample>(200'000);
  std::vector<FitLink> links_ = std::vector<FitLink>(4'000);
  std::vector<Vertex<double>> vertices_ = std::vector<Vertex<double>>(16'000);
};

FitEnd any_end(proof::Random& random) {
  constexpr std::array<FitEnd, 3> kAll{FitEnd::kTangent, FitEnd::kPlace, FitEnd::kFree};
  return kAll[random.below(3)];
}

TEST_F(ArcSplineFit, StaysWithinItsToleranceBothWaysAndHasNoKink) {
  const proof::Trials trials{400};
  std::size_t pieces = 0;
  std::size_t arcs = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE("KERFLINE_SEED=" + std::to_string(seed));
    proof::Random random{seed};
    const exact::RandomCurve curve{random};
    const double offset = random.chance(0.4) ? 0.0 : random.signed_magnitude(0.05, 8.0);
    FitOptions options{.tolerance_mm = random.magnitude(1.0e-3, 0.3)};
    if (random.chance(0.25)) {
      options.method = FitMethod::kBisecting;
    } else {
      options.start = any_end(random);
      options.end = any_end(random);
    }
    for (const CurvePiece& piece : pieces_of(curve.curve(), offset)) {
      const auto count = fit(piece, options);
      ++pieces;
      ASSERT_TRUE(count.ok()) << static_cast<int>(count.error());
      arcs += count.value();
      expect_smooth(chain(count.value()));
      expect_ends(piece, options, chain(count.value()));
      expect_near(piece, options.tolerance_mm, chain(count.value()));
    }
    if (HasFatalFailure() || proof::too_many_failures()) return;
  }
  std::printf("%llu curves, %zu pieces, %zu arcs: greatest deviation %.6f of the tolerance\n",
              static_cast<unsigned long long>(trials.count()),
              pieces,
              arcs,
              worst_);
}

TEST_F(ArcSplineFit, IsOneLineForALineAndOneArcForAnArc) {
  const exact::OwnedNurbs line{3, {{0.0, 0.0}, {1.0, 0.5}, {2.0, 1.0}, {4.0, 2.0}}};
  const EllipseCurve arc{{.major = {5.0, 0.0}, .minor = {0.0, 5.0}, .start = 0.5, .end = 2.0}};
  for (const PlaneCurve* curve :
       {static_cast<const PlaneCurve*>(&line.curve()), static_cast<const PlaneCurve*>(&arc)}) {
    const auto count = fit(pieces_of(*curve, 0.0).front(), {.tolerance_mm = 0.01});
    ASSERT_TRUE(count.ok());
    EXPECT_EQ(count.value(), 1U);
  }
  EXPECT_NEAR(vertices_[0].bulge, std::tan(1.5 / 4.0), 1.0e-12);
}

TEST_F(ArcSplineFit, SaysWhenThereIsNoRoom) {
  const exact::EightCurves curves;
  const CurvePiece piece = pieces_of(*curves.all().front().curve, 0.0).front();
  const FitOptions options{.tolerance_mm = 0.01};
  const auto few_samples =
      fit_arcs(piece, options, {std::span{samples_}.first(50), links_}, vertices_);
  ASSERT_FALSE(few_samples.ok());
  EXPECT_EQ(few_samples.error(), FitError::kTooManySamples);
  const auto few_links =
      fit_arcs(piece, options, {samples_, std::span{links_}.first(9)}, vertices_);
  ASSERT_FALSE(few_links.ok());
  EXPECT_EQ(few_links.error(), FitError::kTooManyArcs);
  for (const FitMethod method : {FitMethod::kFewest, FitMethod::kBisecting}) {
    const auto few_arcs = fit_arcs(piece,
                                   {.tolerance_mm = 0.01, .method = method},
                                   {samples_, links_},
                                   std::span{vertices_}.first(9));
    ASSERT_FALSE(few_arcs.ok());
    EXPECT_EQ(few_arcs.error(), FitError::kTooManyArcs);
  }
}

}  // namespace
}  // namespace cnc::contour
