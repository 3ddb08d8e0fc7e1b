#include "host-sim/cut/timeline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "host-sim/cut/heat.hpp"
#include "host-sim/cut/rapid_way.hpp"
#include "host-sim/job/job.hpp"
#include "tests/host-sim/cut/random_sheet.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

LayerSettings random_settings(proof::Random& random) {
  LayerSettings settings;
  settings.lead_in = {random.chance(0.5) ? LeadKind::kArc : LeadKind::kLine,
                      random.between(0.5, 3.0)};
  if (random.chance(0.5)) settings.lead_out = {LeadKind::kLine, random.between(0.5, 2.0)};
  if (random.chance(0.5)) settings.pierce_s = random.between(0.05, 0.6);
  if (random.chance(0.3)) settings.tabs = 2;
  if (random.chance(0.3)) settings.corner_dwell_s = random.between(0.05, 0.3);
  return settings;
}

TEST(CutTimeline, LosesNoTimeAndNoPlaceBetweenItsSteps) {
  for (const std::uint64_t seed : proof::Trials{60}) {
    proof::Random random{seed};
    const RandomSheet sheet = random_sheet(random, 2, 2);
    const drawing::Drawing drawn = drawing::read(drawing::svg_of(sheet.content));
    const CutPlan plan = plan_of(drawn, random_settings(random));
    const Timeline timeline = timeline_of(plan);
    Place here{0.0, 0.0};
    double now = 0.0;
    for (const TimeStep& step : timeline.steps) {
      EXPECT_EQ(step.begin_s, now);
      EXPECT_GE(step.end_s, now);
      EXPECT_LT(drawing::distance(step.path.from, here), 1.0e-9);
      here = step.path.to;
      now = step.end_s;
    }
    EXPECT_LT(drawing::distance(here, {0.0, 0.0}), 1.0e-9);
    const auto sums = timeline.by_kind();
    EXPECT_NEAR(std::accumulate(sums.begin(), sums.end(), 0.0), timeline.total_s(), 1.0e-9);
    EXPECT_NEAR(scaled_to(timeline, 77.0).total_s(), 77.0, 1.0e-9);
  }
}

/// Written by the program's own writer and driven by the simulated controller.
double driven_seconds(const drawing::Drawing& drawn,
                      const CutPlan& plan,
                      const std::vector<SettingChange>& settings) {
  const Beam beam{.full_power_w = 3000.0};
  Job job{.file = "test", .text = program_of(plan, drawn, beam, cnc::gcode::PrintGrid{4}, {})};
  job.settings = settings;
  const Report report = check(job);
  EXPECT_TRUE(report.faults.empty());
  return report.job_time_s;
}

TEST(CutTimeline, IsWithinTwoPercentOfTheDrivenJob) {
  for (const std::uint64_t seed : proof::Trials{12}) {
    proof::Random random{seed};
    const RandomSheet sheet = random_sheet(random, 2, 2);
    const drawing::Drawing drawn = drawing::read(drawing::svg_of(sheet.content));
    CutPlan plan = plan_of(drawn, random_settings(random));
    std::vector<SettingChange> settings{parse_setting("$32=1", "test")};
    const double acceleration = random.magnitude(800.0, 3'000.0);
    const double rate = random.magnitude(6'000.0, 15'000.0);
    for (const char* axis : {"0", "1"}) {
      settings.push_back(parse_setting(fmt::format("$12{}={:.0f}", axis, acceleration), "test"));
      settings.push_back(parse_setting(fmt::format("$11{}={:.0f}", axis, rate), "test"));
    }
    plan.order.wish.limits = {{rate / 60.0, rate / 60.0}, {acceleration, acceleration}};
    predict(plan);
    const double driven = driven_seconds(drawn, plan, settings);
    EXPECT_NEAR(timeline_of(plan).total_s(), driven, 0.02 * driven);
    EXPECT_NEAR(timeline_of(plan).total_s(), plan.order.predicted_s(), 1.0e-9 * driven);
  }
}

TEST(PierceHeat, IsTheSumOverWhatWasPiercedBefore) {
  proof::Random random{proof::test_seed()};
  const RandomSheet sheet = random_sheet(random, 2, 2);
  const drawing::Drawing drawn = drawing::read(drawing::svg_of(sheet.content));
  const CutPlan plan = plan_of(drawn);
  const Timeline timeline = timeline_of(plan);
  const std::vector<double> heat = heat_at_pierces(plan, timeline);
  ASSERT_EQ(heat.size(), plan.cuts.size());
  EXPECT_EQ(heat.front(), 0.0);
  for (std::size_t i = 0; i < heat.size(); ++i) {
    double sum = 0.0;
    const auto begins = [&](std::size_t cut) {
      return std::ranges::find_if(timeline.steps,
                                  [cut](const TimeStep& step) {
                                    return step.cut == cut && step.kind != TimeKind::kRapid;
                                  })
          ->begin_s;
    };
    for (std::size_t j = 0; j < i; ++j) {
      const double away = drawing::distance(plan.cuts[i].start(), plan.cuts[j].start()) / 10.0;
      sum += std::exp(-(begins(i) - begins(j)) / 10.0) * std::exp(-away * away);
    }
    EXPECT_NEAR(heat[i], sum, 0.01 * static_cast<double>(i + 1));
  }
}

}  // namespace
}  // namespace sim::cut
