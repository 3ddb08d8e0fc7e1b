#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using testing::HasSubstr;

/// Returns a drawing of lines with these paths.
drawing::Drawing lines(const std::string& paths) {
  return drawing::read(drawing::svg_of("<g stroke='red' fill='none'>" + paths + "</g>"));
}

double length_of_all(const CutPlan& plan) {
  double sum = 0.0;
  for (const Cut& cut : plan.cuts) {
    sum += length_of(cut.strokes);
  }
  return sum;
}

std::string warnings_of(const CutPlan& plan) {
  std::string all;
  for (const drawing::Fault& warning : plan.warnings) all += warning.reason + "\n";
  return all;
}

TEST(DoubledLines, TheSecondOneKeepsWhatIsItsOwn) {
  const CutPlan plan = plan_of(lines("<path d='M10 20H40'/><path d='M30 20H50'/>"));
  EXPECT_EQ(plan.cuts.size(), 2U);
  EXPECT_NEAR(length_of_all(plan), 40.0, 1.0e-6);
  EXPECT_THAT(warnings_of(plan),
              HasSubstr("1 line runs along others within 0.01 mm, this one "
                        "first; the common path is driven once, which leaves out "
                        "10.000 mm"));
}

TEST(DoubledLines, InBothDirectionsOnArcsAndWithinATouch) {
  EXPECT_NEAR(
      length_of_all(plan_of(lines("<path d='M10 20H40'/><path d='M50 20.009H30'/>"))), 40.0, 0.01);
  const double half_turn = 10.0 * std::numbers::pi;
  EXPECT_NEAR(length_of_all(plan_of(lines("<path d='M10 50A10 10 0 0 1 30 50'/>"
                                          "<path d='M30 50A10 10 0 0 0 20 40V20'/>"))),
              half_turn + 20.0,
              0.01);
}

TEST(DoubledLines, OnesThatCrossOrMeetAreWhole) {
  const CutPlan plan =
      plan_of(lines("<path d='M10 20H40'/><path d='M10 25L40 15.1'/><path d='M40 20H60'/>"
                    "<path d='M10 20.05H40'/>"));
  EXPECT_EQ(warnings_of(plan).find("runs along"), std::string::npos) << warnings_of(plan);
}

TEST(DoubledLines, ALineThatRunsBackIsDrivenOnce) {
  const CutPlan plan = plan_of(lines("<path d='M10 20H40H25'/>"));
  EXPECT_NEAR(length_of_all(plan), 30.0, 1.0e-6);
  EXPECT_THAT(warnings_of(plan), HasSubstr("15.000 mm"));
}

TEST(DoubledLines, TheEdgeOfAPartGoesBefore) {
  const CutPlan plan =
      plan_of(lines("<path d='M50 20H80'/><path d='M10 10H60V40H10Z'/><path d='M20 10H50'/>"));
  double on_lines = 0.0;
  for (const Cut& cut : plan.cuts) {
    if (cut.area_mm2 != 0.0) continue;
    on_lines += length_of(cut.strokes);
  }
  EXPECT_NEAR(on_lines, 30.0, 1.0e-6) << "that along the upper edge is left out";
}

TEST(DoubledLines, TheDeepestCutGoesBefore) {
  const drawing::Drawing drawn =
      drawing::read(drawing::svg_of("<path d='M10 20H50' stroke='red' fill='none'/>"
                                    "<path d='M30 20H80' stroke='blue' fill='none'/>"));
  auto layers = layers_with(drawn, {});
  layers[0].settings.side = Side::kMark;
  layers[1].settings.side = Side::kOn;
  const CutPlan plan = plan_cuts(drawn, layers);
  ASSERT_EQ(plan.cuts.size(), 2U);
  for (const Cut& cut : plan.cuts) {
    EXPECT_NEAR(length_of(cut.strokes), cut.layer == 0 ? 20.0 : 50.0, 1.0e-6);
  }
}

/// Random stretches of one line have both directions. The driven length must equal the length of
/// their union, which a count of small steps measures.
TEST(DoubledLines, RandomStretchesOfALineAreDrivenOnce) {
  constexpr std::size_t kPlaces = 200;
  for (const std::uint64_t seed : proof::Trials{2'000}) {
    proof::Random random{seed};
    std::vector<bool> is_covered(kPlaces, false);
    std::string paths;
    const std::size_t count = 2 + random.below(8);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from = random.below(kPlaces);
      const std::size_t to = from + 1 + random.below(kPlaces - from);
      const bool is_back = random.chance(0.5);
      paths += fmt::format("<path d='M{} 20H{}'/>",
                           0.5 * static_cast<double>(is_back ? to : from),
                           0.5 * static_cast<double>(is_back ? from : to));
      for (std::size_t k = from; k < to; ++k) is_covered[k] = true;
    }
    const double expected_mm = 0.5 * static_cast<double>(std::ranges::count(is_covered, true));
    const CutPlan plan = plan_of(lines(paths), {.side = Side::kOn});
    EXPECT_NEAR(length_of_all(plan), expected_mm, 1.0e-6) << "seed " << seed << ": " << paths;
  }
}

}  // namespace
}  // namespace sim::cut
