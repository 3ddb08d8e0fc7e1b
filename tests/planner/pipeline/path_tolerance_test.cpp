#include "planner/pipeline/path_tolerance.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

constexpr UsualTolerance kUsual{.path_mm = 0.02F, .arc_mm = 0.004F};

TEST(PathTolerance, SharesTheUsualOneUnderG61) {
  const path::Tolerance tolerance = path_tolerance({}, kUsual);
  EXPECT_FLOAT_EQ(tolerance.weld_mm, 0.004F);
  EXPECT_FLOAT_EQ(tolerance.corner_mm, 0.016F);
}

TEST(PathTolerance, IsNoneUnderExactStops) {
  const path::Tolerance tolerance = path_tolerance({.mode = gcode::PathMode::kStop}, kUsual);
  EXPECT_EQ(tolerance.weld_mm, 0.0F);
  EXPECT_EQ(tolerance.corner_mm, 0.0F);
}

TEST(PathTolerance, IsThatOfG64WithPAlsoForWelds) {
  const path::Tolerance tolerance =
      path_tolerance({.mode = gcode::PathMode::kBlend, .tolerance_mm = 0.1F}, kUsual);
  EXPECT_EQ(tolerance.corner_mm, 0.1F);
  EXPECT_EQ(tolerance.weld_mm, 0.1F);
}

TEST(PathTolerance, TakesQForWeldsAndTheUsualOneForCornersWithoutP) {
  const gcode::PathControl control{.mode = gcode::PathMode::kBlend, .naive_tolerance_mm = 0.05F};
  EXPECT_EQ(path_tolerance(control, kUsual).corner_mm, 0.02F);
  EXPECT_EQ(path_tolerance(control, kUsual).weld_mm, 0.05F);
  EXPECT_EQ(spline_tolerance(control, kUsual), 0.05F);
}

TEST(SplineTolerance, IsTheUsualOneAndNeverBelowWhatArcsCanKeep) {
  EXPECT_EQ(spline_tolerance({}, kUsual), 0.004F);
  EXPECT_EQ(spline_tolerance({}, {.arc_mm = 0.0F}), ArcFit::kMinToleranceMm);
}

}  // namespace
}  // namespace cnc
