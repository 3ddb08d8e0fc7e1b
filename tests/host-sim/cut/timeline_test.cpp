#include "host-sim/cut/timeline.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "host-sim/cut/controller_clock.hpp"
#include "host-sim/cut/heat.hpp"
#include "host-sim/cut/job_clock.hpp"
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

/// The time of a long job is predicted in ranges of cuts. Predicting the complete job at once gives
/// the same time for each motion.
TEST(CutTimeline, IsThatOfTheWholeJobHoweverLongItIs) {
  std::string content;
  for (int i = 0; i < 1'100; ++i) {
    std::string outline;
    for (int k = 0; k < 50; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / 50.0;
      const double radius = k % 2 == 0 ? 2.0 : 2.2;
      outline += fmt::format("{:.4f},{:.4f} ",
                             5.0 * (i % 40) + 3.0 + radius * std::cos(angle),
                             5.0 * (i / 40) + 3.0 + radius * std::sin(angle));
    }
    content += "<polygon points='" + outline + "'/>";
  }
  const drawing::Drawing drawn = drawing::read(drawing::svg_of(content));
  const OrderWish wish{.method = order::OrderMethod::kFile};
  const CutPlan plan = plan_cuts(drawn, layers_with(drawn, {}), {}, WayBeside::kHere, {}, wish);
  const Timeline timeline = timeline_of(plan);
  ASSERT_GT(timeline.steps.size(), 60'000U);
  ControllerClock clock{plan.order.wish};
  for (const TimeStep& step : timeline.steps) {
    const bool is_rapid = step.kind == TimeKind::kRapid;
    const double feed = feed_of(step.path, plan.plan_of(plan.cuts.front()));
    clock.move(step.path, is_rapid ? 0.0 : feed, !is_rapid);
  }
  const std::vector<double> times = clock.finish();
  ASSERT_EQ(times.size(), timeline.steps.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const TimeStep& step = timeline.steps[i];
    ASSERT_NEAR(step.end_s - step.begin_s, times[i], 1.0e-8) << i;
  }
}

/// Returns the duration of a plan, written by the program's writer and run by the simulated
/// controller.
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

/// Limits of both axes.
struct AxisLimits {
  double rate_mm_min = 0.0;
  double acceleration_mm_s2 = 0.0;
  double jerk_mm_s3 = 0.0;  ///< Jerk limit, mm/s³; 0 for none.

  [[nodiscard]] std::vector<SettingChange> settings() const {
    std::vector<SettingChange> changes{parse_setting("$32=1", "test")};
    for (const char* axis : {"0", "1"}) {
      const auto set = [&](const char* group, double value) {
        changes.push_back(parse_setting(fmt::format("${}{}={:.3f}", group, axis, value), "test"));
      };
      set("11", rate_mm_min);
      set("12", acceleration_mm_s2);
      set("80", jerk_mm_s3);
    }
    return changes;
  }
  [[nodiscard]] cnc::order::RapidLimits rapids() const {
    const double rate = rate_mm_min / 60.0;
    return {{rate, rate}, {acceleration_mm_s2, acceleration_mm_s2}, {jerk_mm_s3, jerk_mm_s3}};
  }
};

/// Returns random limits.
/// @param jerk_mm_s3 least jerk; half of the results have no limit
AxisLimits random_limits(proof::Random& random, double jerk_mm_s3) {
  constexpr double kMaxJerk = 1.0e6;
  return {random.magnitude(6'000.0, 15'000.0),
          random.magnitude(500.0, 3'000.0),
          random.chance(0.5) ? 0.0 : random.magnitude(jerk_mm_s3, kMaxJerk)};
}

/// Predicts and runs a sheet. Returns the difference as a fraction of the duration of the run.
double excess_of_prediction(const std::string& content,
                            const LayerSettings& settings,
                            const AxisLimits& limits) {
  const drawing::Drawing drawn = drawing::read(drawing::svg_of(content));
  CutPlan plan = plan_of(drawn, settings);
  plan.order.wish.limits = limits.rapids();
  const double predicted = predict(plan).total_s();
  EXPECT_NEAR(predicted, plan.order.predicted_s(), 1.0e-9 * predicted);
  return predicted / driven_seconds(drawn, plan, limits.settings()) - 1.0;
}

/// Returns four polygons and ellipses in rows of two.
std::string cornered_sheet(proof::Random& random) {
  std::string content;
  for (int i = 0; i < 4; ++i) {
    const double x = 25.0 + 50.0 * (i % 2);
    const double y = 25.0 + 50.0 * (i / 2);
    if (random.chance(0.3)) {
      content += fmt::format(R"(<ellipse id="e{}" cx="{}" cy="{}" rx="{:.2f}" ry="{:.2f}"/>)",
                             i,
                             x,
                             y,
                             random.between(3.0, 20.0),
                             random.between(3.0, 20.0));
      continue;
    }
    const std::size_t corners = 3 + random.below(6);
    std::string places;
    for (std::size_t k = 0; k < corners; ++k) {
      const double radius = random.between(8.0, 22.0);
      const double angle =
          2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
      places +=
          fmt::format("{:.3f},{:.3f} ", x + radius * std::cos(angle), y + radius * std::sin(angle));
    }
    content += fmt::format(R"(<polygon id="q{}" points="{}"/>)", i, places);
  }
  return content;
}

TEST(CutTimeline, IsWithinOnePercentOfTheDrivenJob) {
  for (const std::uint64_t seed : proof::Trials{20}) {
    proof::Random random{seed};
    const RandomSheet sheet = random_sheet(random, 2, 2);
    const LayerSettings settings = random_settings(random);
    const AxisLimits limits = random_limits(random, 1.0e4);
    EXPECT_NEAR(excess_of_prediction(sheet.content, settings, limits), 0.0, 0.01);
  }
}

/// Stops at corners and short rapids leave the controller little time to read ahead, and the window
/// that it then chooses is an estimate.
TEST(CutTimeline, IsWithinTwoPercentWhereThePathHasCorners) {
  for (const std::uint64_t seed : proof::Trials{20}) {
    proof::Random random{seed};
    const std::string content = cornered_sheet(random);
    LayerSettings settings = random_settings(random);
    if (random.chance(0.5)) settings.side = Side::kOn;
    const AxisLimits limits = random_limits(random, 1.0e4);
    EXPECT_NEAR(excess_of_prediction(content, settings, limits), 0.0, 0.02);
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
