#include "host-sim/cut/part_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host-sim/cut/cut_account.hpp"
#include "tests/host-sim/cut/random_sheet.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

const PriceList kShopPrices{.per_hour = 90.0, .per_sheet = 33.0, .currency = "EUR"};

TEST(PartTable, FindsCopiesWhereverTheyLie) {
  const drawing::Drawing drawn = drawing::read(drawing::svg_of(
      R"(<rect id="a" x="5" y="5" width="20" height="12"/><circle cx="12" cy="11" r="3"/>)"
      R"(<rect id="b" x="5" y="40" width="12" height="20"/><circle cx="11" cy="50" r="3"/>)"
      R"(<rect id="c" x="40" y="5" width="20" height="12"/><circle cx="50" cy="11" r="3.2"/>)"
      R"(<rect id="d" x="40" y="40" width="20" height="12"/>)"));
  const CutPlan plan = plan_of(drawn);
  const auto rows = part_table(drawn, plan, timeline_of(plan), {});
  ASSERT_EQ(rows.size(), 3U);
  std::size_t copies = 0;
  for (const PartRow& row : rows) {
    copies += row.copies;
    EXPECT_EQ(row.pierces, row.copies * (row.name == R"(rect "d")" ? 1U : 2U)) << row.name;
    EXPECT_GE(row.number, 1U);
    EXPECT_LE(row.number, plan.cuts.size());
    if (row.copies == 2) {
      EXPECT_NEAR(row.area_mm2, 2.0 * (240.0 - 9.0 * M_PI), 0.01);
    }
  }
  EXPECT_EQ(copies, 4U);
}

TEST(PartTable, HasAPartInAHoleAsAPartOfItsOwnAndMarksWithThePartAroundThem) {
  const drawing::Drawing drawn = drawing::read(drawing::svg_of(
      R"(<rect id="plate" x="5" y="5" width="80" height="60"/><circle cx="30" cy="30" r="15"/>)"
      R"(<circle id="disc" cx="30" cy="30" r="8"/><path d="M27 30H33" stroke="red"/>)"
      R"(<path d="M60 20H70" stroke="red"/><path d="M5 90H70" stroke="red"/>)"));
  std::vector<LayerPlan> layers = layers_with(drawn, {});
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (drawn.layers[i].colour == "red") layers[i].settings.side = Side::kOn;
  }
  const CutPlan plan = plan_cuts(drawn, layers);
  const auto rows = part_table(drawn, plan, timeline_of(plan), {});
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].name, R"(circle "disc")");
  EXPECT_EQ(rows[0].pierces, 2U);
  EXPECT_EQ(rows[1].name, R"(rect "plate")");
  EXPECT_EQ(rows[1].pierces, 3U);
  EXPECT_EQ(rows[2].name, "on the sheet");
  EXPECT_EQ(rows[2].pierces, 1U);
  EXPECT_NEAR(rows[1].area_mm2, 4800.0 - 225.0 * M_PI, 0.01);
}

TEST(PartTable, AddsUpToTheTimeAndTheCostOfTheJob) {
  for (const std::uint64_t seed : proof::Trials{60}) {
    proof::Random random{seed};
    const RandomSheet sheet = random_sheet(random, 2, 2);
    const drawing::Drawing drawn = drawing::read(drawing::svg_of(sheet.content));
    const CutPlan plan = plan_of(drawn);
    const double job_time_s = random.between(5.0, 500.0);
    const CutAccount account = account_of(drawn, plan, timeline_of(plan), job_time_s, kShopPrices);
    PartRow sum;
    double cost = 0.0;
    for (const PartRow& row : account.parts) {
      sum.copies += row.copies;
      sum.pierces += row.pierces;
      sum.cut_length_mm += row.cut_length_mm;
      sum.time_s += row.time_s;
      cost += row.cost.total();
    }
    EXPECT_EQ(sum.copies, sheet.plain + 2 * sheet.with_hole);
    EXPECT_EQ(sum.pierces, plan.cuts.size());
    double length = 0.0;
    for (const Cut& cut : plan.cuts) length += length_of(cut.strokes);
    EXPECT_NEAR(sum.cut_length_mm, length, 1.0e-6);
    EXPECT_NEAR(sum.time_s, job_time_s, 1.0e-6);
    EXPECT_NEAR(cost, 90.0 * job_time_s / 3600.0 + 33.0, 1.0e-6);
    EXPECT_NEAR(account.cost.total(), cost, 1.0e-6);
    EXPECT_THAT(lines_of(account, drawn), testing::Contains(testing::HasSubstr("EUR each")));
  }
}

TEST(PartTable, CountsPredictedTimesWhereTheMachineRefusedTheProgram) {
  const drawing::Drawing drawn =
      drawing::read(drawing::svg_of(R"(<rect x="5" y="5" width="20" height="12"/>)"));
  const CutPlan plan = plan_of(drawn);
  const Timeline predicted = timeline_of(plan);
  const CutAccount account = account_of(drawn, plan, predicted, 0.0, {});
  EXPECT_EQ(account.timeline.total_s(), predicted.total_s());
  EXPECT_EQ(lines_of(account, drawn).size(), 1U);
}

}  // namespace
}  // namespace sim::cut
