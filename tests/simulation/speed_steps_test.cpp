#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "host-sim/machine/simulator.hpp"

namespace proof {
namespace {

constexpr double kMotorStepsPerMm = 500.0;
constexpr double kSpeedWindow = 0.5e-3;  // Window of a mean speed, s.

/// Records the times of the steps of X, s.
class StepTimes final : public sim::TraceSink {
 public:
  void on_row(const sim::TraceRow& row) override {
    if (row.position[0] == last_) return;
    last_ = row.position[0];
    times.push_back(static_cast<double>(row.time_ns) * 1.0e-9);
  }
  std::vector<double> times;

 private:
  std::int32_t last_ = 0;
};

std::vector<double> step_times(double acceleration, double jerk) {
  sim::Simulator simulator{"G21 G90 G1 X100 F12000\nM2\n", {}};
  const auto set = [&](std::uint16_t number, double value) {
    EXPECT_EQ(simulator.change_setting(number, static_cast<float>(value)), "");
  };
  set(0, 1.0);
  set(cnc::setting::kStepsPerMm, kMotorStepsPerMm);
  set(cnc::setting::kRate, 12'000.0);
  set(cnc::setting::kAcceleration, acceleration);
  set(cnc::setting::kJerk, jerk);
  StepTimes sink;
  simulator.add_sink(sink);
  EXPECT_TRUE(simulator.run().refusals.empty());
  return sink.times;
}

/// Returns the mean speed over the window that ends with this step, mm/s.
double speed_before(const std::vector<double>& times, std::size_t step) {
  std::size_t first = step;
  while (first > 0 && times[step] - times[first] < kSpeedWindow) --first;
  return static_cast<double>(step - first) / kMotorStepsPerMm / (times[step] - times[first]);
}

/// Returns the least growth of the speed within a millisecond while it speeds up, as a share of the
/// growth by the acceleration.
double min_growth(double acceleration, double jerk) {
  constexpr double kMillisecond = 1.0e-3;
  const std::vector<double> times = step_times(acceleration, jerk);
  // From here on, a window contains enough steps for a mean speed, and the acceleration is still
  // full.
  const double rise = jerk > 0.0 ? acceleration / jerk : 0.0;
  const double from = rise + 40.0 / acceleration;
  const double to = 190.0 / acceleration;
  double least = 1.0e9;
  std::size_t later = 0;
  for (std::size_t step = 0; step < times.size(); ++step) {
    while (later < times.size() && times[later] < times[step] + kMillisecond) ++later;
    const double since = times[step] - times.front();
    if (since < from || since > to || later >= times.size()) continue;
    const double growth = speed_before(times, later) - speed_before(times, step);
    least = std::min(least, growth / (acceleration * (times[later] - times[step])));
  }
  return least;
}

// Issue 4, acceptance 5: while it speeds up, the speed must not stay constant for a millisecond, as
// in a staircase of speeds.
TEST(SpeedingUp, HasNoPlateauOfAMillisecond) {
  for (const double acceleration : {500.0, 3000.0}) {
    for (const double rise : {0.0, 0.02}) {
      SCOPED_TRACE(testing::Message() << acceleration << " mm/s², " << rise << " s to reach it");
      const double growth = min_growth(acceleration, rise > 0.0 ? acceleration / rise : 0.0);
      std::printf("speed grows in each millisecond by at least %.3f of the acceleration\n", growth);
      EXPECT_GT(growth, 0.5);
    }
  }
}

}  // namespace
}  // namespace proof
