#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/planner/pocket/pocket_bench.hpp"
#include "tests/planner/pocket/pocket_oracle.hpp"
#include "tests/support/contour_corpus.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::pocket::PocketBench;
using cnc::pocket::PocketOracle;

struct PocketFamily {
  Corpus corpus;
  std::uint64_t usual;
};

void PrintTo(const PocketFamily& family, std::ostream* out) { *out << name_of(family.corpus); }

class PocketCorpora : public testing::TestWithParam<PocketFamily> {};

/// Returns the longer side of the box around a contour, mm.
double size_of(const sim::Contour& contour) {
  double low_x = 1e30, high_x = -1e30, low_y = 1e30, high_y = -1e30;
  for (const sim::ContourVertex& vertex : contour.vertices) {
    low_x = std::min(low_x, vertex.x);
    high_x = std::max(high_x, vertex.x);
    low_y = std::min(low_y, vertex.y);
    high_y = std::max(high_y, vertex.y);
  }
  return std::max(high_x - low_x, high_y - low_y);
}

std::string complaint_about_pocket(Corpus corpus, std::uint64_t seed, double& worst) {
  const OffsetCase drawn = random_case(corpus, seed);
  Random random{seed};
  const double size = size_of(drawn.contour);
  const double radius = std::clamp(std::abs(drawn.distance_mm), 0.02 * size, 0.1 * size);
  PocketBench bench;
  for (std::size_t loop = 0; loop < drawn.contour.loop_ends.size(); ++loop) {
    const auto view = drawn.contour.view();
    for (std::uint32_t i = view.loop_begin(loop); i < view.loop_ends[loop]; ++i) {
      bench.add(view.vertices[i].x, view.vertices[i].y, view.vertices[i].bulge);
    }
    bench.close();
  }
  const double corner = random.chance(0.5) ? random.between(0.0, 0.33) * radius : 0.0;
  const auto count =
      bench.clear({.tool_radius = radius, .corner_radius = corner, .stepover = 2.0 * radius});
  if (!count.ok()) {
    return "fault " + std::to_string(static_cast<int>(count.error().fault)) + ", offset " +
           std::to_string(static_cast<int>(count.error().offset.fault));
  }
  sim::ContourOffset offsetter;
  PocketOracle oracle{drawn.plain.view(), offsetter.offset(drawn.contour.view(), -radius), radius};
  for (std::size_t i = 0; i < count.value(); ++i) oracle.add_pass(bench.passes().loops(i));
  const double far = oracle.farthest(random, 200) - radius;
  worst = std::max(worst, far);
  if (far > 1.0e-6) return "leaves " + std::to_string(far) + " mm";
  const double clearance = count.value() > 0 ? oracle.min_clearance() - radius : 0.0;
  return clearance < -1.0e-6 ? "gouges by " + std::to_string(-clearance) : std::string{};
}

TEST_P(PocketCorpora, AreClearedWhereverTheToolReaches) {
  double worst = -1.0;
  for (const std::uint64_t seed : Trials{GetParam().usual}) {
    const std::string complaint = complaint_about_pocket(GetParam().corpus, seed, worst);
    EXPECT_EQ(complaint, "") << name_of(GetParam().corpus) << " KERFLINE_SEED=" << seed;
  }
  std::printf("at most %.2g mm beyond the radius\n", worst);
}

INSTANTIATE_TEST_SUITE_P(All,
                         PocketCorpora,
                         testing::Values(PocketFamily{Corpus::kStar20, 60},
                                         PocketFamily{Corpus::kStar100, 10},
                                         PocketFamily{Corpus::kNest, 40},
                                         PocketFamily{Corpus::kGlyphs, 40},
                                         PocketFamily{Corpus::kMech, 150},
                                         PocketFamily{Corpus::kIslands, 10},
                                         PocketFamily{Corpus::kHostile, 150}),
                         [](const auto& family) {
                           return std::string{name_of(family.param.corpus)};
                         });

}  // namespace
}  // namespace proof
