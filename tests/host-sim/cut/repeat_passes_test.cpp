#include "host-sim/cut/repeat_passes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "host-sim/cut/rapid_way.hpp"
#include "tests/host-sim/cut/support.hpp"

namespace sim::cut {
namespace {

constexpr const char* kWasher =
    "<rect x=\"10\" y=\"10\" width=\"30\" height=\"20\"/><circle cx=\"25\" cy=\"20\" r=\"4\"/>";

drawing::Drawing ring() { return drawing::read(drawing::svg_of(kWasher)); }

std::vector<std::pair<std::size_t, unsigned>> sequence_of(const CutPlan& plan) {
  std::vector<std::pair<std::size_t, unsigned>> sequence;
  for (const Cut& cut : plan.cuts) sequence.emplace_back(cut.contour, cut.pass);
  return sequence;
}

TEST(RepeatPasses, RepeatsEachContourBeforeTheNext) {
  const drawing::Drawing drawn = ring();
  CutPlan plan = plan_of(drawn, {.passes = 3});
  ASSERT_EQ(plan.cuts.size(), 2U);
  const CutPlan once = plan;
  repeat_passes(plan, {});
  const std::size_t hole = once.cuts[0].contour;
  const std::size_t outer = once.cuts[1].contour;
  EXPECT_THAT(sequence_of(plan),
              testing::ElementsAre(testing::Pair(hole, 1U),
                                   testing::Pair(hole, 2U),
                                   testing::Pair(hole, 3U),
                                   testing::Pair(outer, 1U),
                                   testing::Pair(outer, 2U),
                                   testing::Pair(outer, 3U)));
  EXPECT_EQ(plan.cuts[3].after, std::vector<std::size_t>{2}) << "the hole is through by then";
  EXPECT_EQ(length_of(plan.cuts[5].strokes), length_of(once.cuts[1].strokes));
}

TEST(RepeatPasses, RepeatsALayerAsAWhole) {
  const drawing::Drawing drawn = ring();
  CutPlan plan = plan_of(drawn, {.passes = 2, .passes_by_layer = true});
  const std::size_t hole = plan.cuts[0].contour;
  const std::size_t outer = plan.cuts[1].contour;
  repeat_passes(plan, {});
  EXPECT_THAT(sequence_of(plan),
              testing::ElementsAre(testing::Pair(hole, 1U),
                                   testing::Pair(outer, 1U),
                                   testing::Pair(hole, 2U),
                                   testing::Pair(outer, 2U)));
}

TEST(RepeatPasses, GoesBackAlongAnOpenLine) {
  const drawing::Drawing drawn = drawing::read(drawing::svg_of("<path d=\"M10 10H30V20\"/>"));
  CutPlan plan = plan_of(drawn, {.side = Side::kMark, .passes = 2});
  repeat_passes(plan, {});
  ASSERT_EQ(plan.cuts.size(), 2U);
  EXPECT_EQ(plan.cuts[1].start(), plan.cuts[0].end());
  EXPECT_EQ(plan.cuts[1].end(), plan.cuts[0].start());
}

TEST(RepeatPasses, LowersZWithEachPassAndRaisesItAtTheEnd) {
  const drawing::Drawing drawn = ring();
  CutPlan plan = plan_of(drawn, {.passes = 2, .z_step_mm = 0.5});
  repeat_passes(plan, {});
  const std::string program =
      program_of(plan, drawn, {.full_power_w = 2000.0}, cnc::gcode::PrintGrid{4}, {});
  std::vector<std::string> heights;
  for (std::size_t at = program.find('Z'); at != std::string::npos;
       at = program.find('Z', at + 1)) {
    heights.push_back(program.substr(at, program.find_first_of(" \n", at) - at));
  }
  EXPECT_THAT(heights, testing::ElementsAre("Z-0.5", "Z0", "Z-0.5", "Z0"));
}

TEST(RepeatPasses, RefusesWhatCountsOnOnePass) {
  CutPlan plan = plan_of(ring(), {.passes = 2});
  EXPECT_THROW(repeat_passes(plan, {.cool_s = 1.0}), std::invalid_argument);
  EXPECT_THROW(repeat_passes(plan, {.chain_mm = 1.0}), std::invalid_argument);
  CutPlan once = plan_of(ring());
  EXPECT_NO_THROW(repeat_passes(once, {.cool_s = 1.0}));
}

}  // namespace
}  // namespace sim::cut
