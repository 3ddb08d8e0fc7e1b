#include "host-sim/cut/open_lines.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host-sim/cut/support.hpp"

namespace sim::cut {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST(OpenLines, AreCutOnTheLineAndToldOncePerLayer) {
  const drawing::Drawing drawn =
      drawing::read(drawing::svg_of("<g stroke='red' fill='none'><path d='M10 10H40V40H10Z'/>"
                                    "<path d='M15 20H35M15 22H35M15 24H35'/></g>"));
  const CutPlan plan = plan_of(drawn);
  EXPECT_THAT(plan.faults, IsEmpty());
  ASSERT_EQ(plan.cuts.size(), 4U);
  ASSERT_EQ(plan.warnings.size(), 1U);
  EXPECT_THAT(plan.warnings[0].reason, HasSubstr("3 open contours of layer \"\" red"));
  EXPECT_FALSE(drawn.contours[plan.cuts.front().contour].closed) << "before the part is free";
  EXPECT_TRUE(drawn.contours[plan.cuts.back().contour].closed);
  for (const Cut& cut : plan.cuts) {
    if (drawn.contours[cut.contour].closed) continue;
    EXPECT_EQ(plan.plan_of(cut).settings.side, Side::kOn);
    ASSERT_EQ(cut.strokes.size(), 1U);
    EXPECT_NEAR(length_of(cut.strokes[0]), 20.0, 1.0e-9);
  }
}

TEST(OpenLines, OnesThatMayBeMeantClosedAreLeftToTheFaults) {
  const drawing::Drawing drawn =
      drawing::read(drawing::svg_of("<g stroke='red' fill='none'><path d='M10 10H40V40'/>"
                                    "<path d='M40 40.25H10V10.25'/></g>"));
  const CutPlan plan = plan_of(drawn);
  EXPECT_THAT(plan.cuts, IsEmpty());
  EXPECT_THAT(plan.warnings, IsEmpty());
  for (const drawing::Fault& fault : drawn.faults) {
    EXPECT_EQ(fault.kind, drawing::FaultKind::kOpen);
    EXPECT_FALSE(fault.is_of_line);
  }
  EXPECT_EQ(drawn.faults.size(), 2U);
}

TEST(OpenLines, KeepTheRulesOfTheShop) {
  const drawing::Drawing drawn = drawing::read(drawing::svg_of(
      "<g stroke='red' fill='none'><path d='M15 20H35'/><path d='M15 24H55'/></g>"));
  const std::vector<LayerPlan> layers = layers_with(drawn, {});
  Recipes recipes;
  recipes.plans.push_back(layers[0]);
  recipes.plans[0].settings.side = Side::kSkip;
  recipes.by_contour = {Recipes::kOfLayer, 0};
  const auto warnings = cut_open_on_line(drawn, layers, recipes);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_THAT(warnings[0].reason, HasSubstr("1 open contour of layer"));
  EXPECT_EQ(recipes.of(0, layers[0]).settings.side, Side::kOn);
  EXPECT_EQ(recipes.of(1, layers[0]).settings.side, Side::kSkip);
}

}  // namespace
}  // namespace sim::cut
