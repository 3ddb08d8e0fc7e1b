#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <exception>

#include "tests/support/contour_oracle.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

struct Family {
  Corpus corpus;
  std::uint64_t usual;  ///< Trials unless KERFLINE_TRIALS is set; they take some seconds.
};

void PrintTo(const Family& family, std::ostream* out) { *out << name_of(family.corpus); }

class OffsetCorpora : public testing::TestWithParam<Family> {};

std::string complaint_about(Corpus corpus, std::uint64_t seed, double& worst) {
  const OffsetCase wanted = random_case(corpus, seed);
  sim::ContourOffset offsetter;
  try {
    const auto result = offsetter.offset(wanted.contour.view(), wanted.distance_mm);
    const OffsetVerdict verdict = check_offset(wanted, result, seed);
    worst = std::max(worst, verdict.worst_deviation);
    return verdict.complaint;
  } catch (const std::exception& error) {
    return error.what();
  }
}

// KERFLINE_TRIALS=20000 runs 120,000 usual offsets and 1,000 hostile ones.
TEST_P(OffsetCorpora, EveryPlaceIsAtTheDistanceAndNothingIsMissing) {
  const Trials trials{GetParam().usual};
  double worst = 0.0;
  for (const std::uint64_t seed : trials) {
    const std::string complaint = complaint_about(GetParam().corpus, seed, worst);
    EXPECT_EQ(complaint, "") << name_of(GetParam().corpus) << " KERFLINE_SEED=" << seed;
  }
  std::printf("%llu offsets, at most %.2g mm off\n",
              static_cast<unsigned long long>(trials.count()),
              worst);
}

INSTANTIATE_TEST_SUITE_P(All,
                         OffsetCorpora,
                         testing::Values(Family{Corpus::kStar20, 1000},
                                         Family{Corpus::kStar100, 100},
                                         Family{Corpus::kStar1000, 4},
                                         Family{Corpus::kNest, 300},
                                         Family{Corpus::kGlyphs, 200},
                                         Family{Corpus::kSpline, 50},
                                         Family{Corpus::kMech, 2000},
                                         Family{Corpus::kIslands, 100},
                                         Family{Corpus::kHostile, 1000}),
                         [](const auto& family) {
                           return std::string{name_of(family.param.corpus)};
                         });

// Loops that cross, reverse and overlap: any result is allowed, but no crash.
TEST(OffsetOfNonsense, EndsWithAResultOrAReason) {
  const Trials trials{20'000};
  std::uint64_t refused = 0;
  sim::ContourOffset offsetter;
  for (const std::uint64_t seed : trials) {
    Random random{seed};
    sim::Contour contour;
    for (std::size_t left = 1 + random.below(30); left > 0; --left) {
      const auto x = static_cast<double>(random.below(4));
      const auto y = static_cast<double>(random.below(4));
      const double bulge = random.chance(0.5) ? 0.0 : random.signed_magnitude(1.0e-12, 10.0);
      contour.vertices.push_back({x + (random.chance(0.1) ? 1.0e-10 : 0.0), y, bulge});
      if (random.chance(0.1)) contour.end_loop();
    }
    contour.end_loop();
    try {
      const auto result = offsetter.offset(contour.view(), random.signed_magnitude(0.01, 2.0));
      for (const sim::ContourVertex& vertex : result.vertices) {
        ASSERT_TRUE(std::isfinite(vertex.x + vertex.y + vertex.bulge)) << "KERFLINE_SEED=" << seed;
      }
    } catch (const sim::NoOffset&) {
      ++refused;
    }
  }
  if (trials.judges_shares()) {
    EXPECT_LT(refused, trials.count());
  }
}

// Tests the oracles themselves: each must find a fault that the test made.
TEST(OffsetOracle, FindsAWrongDistanceALostLoopAndAWrongTurn) {
  OffsetCase square;
  square.contour.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  square.contour.end_loop();
  square.plain = square.contour;
  square.distance_mm = -1.0;
  sim::Contour wrong = square.contour;
  wrong.vertices = {{1, 1, 0}, {9, 1, 0}, {9, 9, 0}, {1, 9 - 2e-6, 0}};
  EXPECT_NE(check_offset(square, wrong.view(), 1).complaint, "");
  EXPECT_NE(check_offset(square, sim::Contour{}.view(), 1).complaint, "");
  wrong.vertices = {{1, 1, 0}, {1, 9, 0}, {9, 9, 0}, {9, 1, 0}};
  EXPECT_NE(check_offset(square, wrong.view(), 1).complaint, "");
  wrong.vertices = {{1, 1, 0}, {9, 1, 0}, {9, 9, 0}, {1, 9, 0}};
  EXPECT_EQ(check_offset(square, wrong.view(), 1).complaint, "");
}

/// Returns a plate with a clockwise hole. The tip of the hole lies `past_mm` to the right of the
/// middle of the plate's right side.
sim::Contour plate_with_tip(double plate_bulge, double hole_bulge, double past_mm) {
  sim::Contour contour;
  contour.vertices = {{0, 0, 0}, {100, 0, plate_bulge}, {100, 100, 0}, {0, 100, 0}};
  contour.end_loop();
  const double tip = 100.0 + 50.0 * plate_bulge + past_mm;
  for (const sim::ContourVertex& vertex :
       {sim::ContourVertex{50, 60, hole_bulge}, {tip, 50, hole_bulge}, {50, 40, 0}}) {
    contour.vertices.push_back(vertex);
  }
  contour.end_loop();
  return contour;
}

TEST(OffsetOracle, FindsACrossingHoweverShort) {
  for (const double plate_bulge : {0.0, 0.1, -0.1, 1.0e-7}) {
    for (const double hole_bulge : {0.0, 0.05, -0.05, 1.0e-7}) {
      const auto is_crossed = [&](double past_mm) {
        const sim::Contour plate = plate_with_tip(plate_bulge, hole_bulge, past_mm);
        return elements_cross(ExactContour{plate.view()});
      };
      EXPECT_TRUE(is_crossed(1.0e-5)) << plate_bulge << ' ' << hole_bulge;
      EXPECT_FALSE(is_crossed(-1.0e-5)) << plate_bulge << ' ' << hole_bulge;
      EXPECT_FALSE(is_simple(plate_with_tip(plate_bulge, hole_bulge, 0.02).view()));
      EXPECT_TRUE(is_simple(plate_with_tip(plate_bulge, hole_bulge, -0.02).view()));
    }
  }
}

}  // namespace
}  // namespace proof
