#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "tests/planner/geometry/chain_check.hpp"
#include "tests/planner/geometry/fewest_arcs.hpp"
#include "tests/planner/geometry/random_spline.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

struct Counts {
  std::vector<double> ratios{};
  std::size_t arcs = 0;
  std::size_t fewest = 0;

  void add(const Spline& spline, double tolerance) {
    const auto chain = exact::chain_of(spline, {}, tolerance);
    if (chain.size() < 3 || chain.size() > 120) return;
    if (exact::ChainCheck{spline, chain}.corners(tolerance).count > 0) return;
    const std::size_t grid = std::clamp<std::size_t>(30 * chain.size(), 400, 2000);
    const std::size_t least = exact::FewestArcs{spline, tolerance, grid}.count();
    if (least > 1000) return;  // The bend is too tight for the grid: no chain covers it.
    arcs += chain.size();
    fewest += least;
    ratios.push_back(static_cast<double>(chain.size()) / static_cast<double>(least));
    if (std::getenv("KERFLINE_VERBOSE") != nullptr) {
      std::printf("%zu arcs, oracle %zu\n", chain.size(), least);
    }
  }

  void judge(const char* name, const proof::Trials& trials) {
    if (ratios.empty() && !trials.judges_shares()) return;
    ASSERT_FALSE(ratios.empty());
    std::ranges::sort(ratios);
    const double median = ratios[ratios.size() / 2];
    const double total = static_cast<double>(arcs) / static_cast<double>(fewest);
    std::printf(
        "%s: %zu curves, %zu arcs, oracle %zu: total %.4f, median %.4f, 95th %.4f, most %.4f\n",
        name,
        ratios.size(),
        arcs,
        fewest,
        total,
        median,
        ratios[ratios.size() * 95 / 100],
        ratios.back());
    if (!trials.judges_shares()) return;
    EXPECT_LE(total, 1.10);
    EXPECT_LE(median, 1.10);
  }
};

TEST(ArcCount, OfCubicsIsWithinATenthOfTheLeast) {
  const proof::Trials trials{60};
  Counts counts;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    counts.add(exact::random_cubic(random), 0.002);
  }
  counts.judge("cubics", trials);
}

TEST(ArcCount, OfSplinesIsWithinATenthOfTheLeast) {
  const proof::Trials trials{20};
  Counts counts;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    counts.add(exact::random_spline(random), 0.01);
  }
  counts.judge("splines", trials);
}

}  // namespace
}  // namespace cnc
