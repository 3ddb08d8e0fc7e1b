#include "host-sim/cut/timeline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "host-sim/cut/heat.hpp"
#include "host-sim/job/job.hpp"
#include "tests/host-sim/cut/random_sheet.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

constexpr MachineRates kCalm{{200.0, 200.0}, {1500.0, 1500.0}, {0.0, 0.0}, 0.01};

/// Time of a move from rest to rest by adding up short steps: the acceleration grows by the jerk,
/// stays, and falls, as long as the speed that is left to gain allows; the second half mirrors the
/// first.
double stepped_seconds(double length, const PathLimits& limits) {
  constexpr double kStep = 2.0e-6;
  // The greatest speed from which half of the way is left to brake, by bisection over ramps.
  const auto half_way = [&](double top, double& seconds) {
    double speed = 0.0;
    double acceleration = 0.0;
    double way = 0.0;
    seconds = 0.0;
    while (speed < top && way < length) {
      const double to_zero = 0.5 * acceleration * acceleration / limits.jerk_mm_s3;
      const double change = top - speed > to_zero ? limits.jerk_mm_s3 : -limits.jerk_mm_s3;
      acceleration = std::clamp(
          acceleration + change * kStep, limits.jerk_mm_s3 * kStep, limits.acceleration_mm_s2);
      speed += acceleration * kStep;
      way += speed * kStep;
      seconds += kStep;
    }
    return way;
  };
  double low = 0.0;
  double high = limits.speed_mm_s;
  double seconds = 0.0;
  if (half_way(high, seconds) > 0.5 * length) {
    for (int i = 0; i < 24; ++i) {
      const double middle = 0.5 * (low + high);
      (half_way(middle, seconds) > 0.5 * length ? high : low) = middle;
    }
    static_cast<void>(half_way(low, seconds));
    return 2.0 * seconds;
  }
  const double ramp = half_way(high, seconds);
  return 2.0 * seconds + (length - 2.0 * ramp) / high;
}

TEST(MotionTime, OfARestToRestMoveIsThatOfSmallSteps) {
  for (const std::uint64_t seed : proof::Trials{30}) {
    proof::Random random{seed};
    const PathLimits limits{random.magnitude(20.0, 300.0),
                            random.magnitude(500.0, 5'000.0),
                            random.magnitude(2.0e4, 2.0e6)};
    const double length = random.magnitude(0.5, 60.0);
    const double exact = stepped_seconds(length, limits);
    EXPECT_NEAR(seconds_along(length, 0.0, 0.0, limits), exact, 0.004 * exact + 1.0e-4)
        << length << " mm, " << limits.speed_mm_s << ' ' << limits.acceleration_mm_s2 << ' '
        << limits.jerk_mm_s3;
  }
}

TEST(MotionTime, IsTheSameBothWaysAndGrowsWithTheLength) {
  for (const std::uint64_t seed : proof::Trials{2000}) {
    proof::Random random{seed};
    const PathLimits limits{random.magnitude(5.0, 300.0), random.magnitude(50.0, 5'000.0)};
    const double length = random.magnitude(1.0e-3, 1.0e3);
    const double from = random.between(0.0, limits.speed_mm_s);
    const double to = reachable_speed(length, from, limits) * random.unit();
    const double entry = std::min(from, reachable_speed(length, to, limits));
    const double seconds = seconds_along(length, entry, to, limits);
    EXPECT_NEAR(seconds, seconds_along(length, to, entry, limits), 1.0e-9 * seconds);
    EXPECT_LE(seconds, seconds_along(1.1 * length, entry, to, limits));
    EXPECT_GE(seconds, length / limits.speed_mm_s * (1.0 - 1.0e-9));
  }
}

TEST(MotionTime, OfADiagonalRapidHasTheLimitsOfBothAxes) {
  const MachineRates rates{{100.0, 50.0}, {1000.0, 250.0}, {0.0, 0.0}, 0.01};
  const double diagonal = rapid_seconds(rates, {0.0, 0.0}, {300.0, 300.0});
  EXPECT_NEAR(diagonal, 300.0 / 50.0 + 50.0 / 250.0, 1.0e-9);
  EXPECT_NEAR(rapid_seconds(rates, {0.0, 0.0}, {300.0, 0.0}), 3.0 + 0.1, 1.0e-9);
  EXPECT_EQ(rapid_seconds(rates, {1.0, 2.0}, {1.0, 2.0}), 0.0);
}

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
    const Timeline timeline = timeline_of(plan, kCalm);
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
    const CutPlan plan = plan_of(drawn, random_settings(random));
    std::vector<SettingChange> settings{parse_setting("$32=1", "test")};
    const double acceleration = random.magnitude(800.0, 3'000.0);
    const double rate = random.magnitude(6'000.0, 15'000.0);
    for (const char* axis : {"0", "1"}) {
      settings.push_back(parse_setting(fmt::format("$12{}={:.0f}", axis, acceleration), "test"));
      settings.push_back(parse_setting(fmt::format("$11{}={:.0f}", axis, rate), "test"));
    }
    cnc::Settings machine;
    for (const SettingChange& change : settings) {
      ASSERT_TRUE(machine.set(change.number, change.value).ok());
    }
    const double driven = driven_seconds(drawn, plan, settings);
    EXPECT_NEAR(timeline_of(plan, rates_of(machine)).total_s(), driven, 0.02 * driven);
  }
}

TEST(PierceHeat, IsTheSumOverWhatWasPiercedBefore) {
  proof::Random random{proof::test_seed()};
  const RandomSheet sheet = random_sheet(random, 2, 2);
  const drawing::Drawing drawn = drawing::read(drawing::svg_of(sheet.content));
  const CutPlan plan = plan_of(drawn);
  const Timeline timeline = timeline_of(plan, kCalm);
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
