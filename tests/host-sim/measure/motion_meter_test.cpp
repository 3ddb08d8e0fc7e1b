#include "host-sim/measure/motion_meter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/host-sim/measure/synthetic_trace.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using cnc::Axis;

MotionMeter measured(const SyntheticMachine& machine,
                     const std::function<Point(double)>& course,
                     double end_s,
                     const MeterWindows& windows = {}) {
  MotionMeter meter{machine.steps_per_mm, windows};
  play(machine.rows(course, end_s), meter);
  return meter;
}

/// Motion along one axis: ramps at `acceleration` to `speed` and back, at rest at both ends.
struct Ramps {
  double acceleration;
  double speed;
  double distance;

  [[nodiscard]] double ramp_s() const { return speed / acceleration; }
  [[nodiscard]] double end_s() const { return ramp_s() + distance / speed; }
  [[nodiscard]] double at(double time) const {
    const double left = std::max(0.0, end_s() - time);
    if (time <= 0.0) return 0.0;
    if (time < ramp_s()) return acceleration * time * time / 2.0;
    if (left < ramp_s()) return distance - acceleration * left * left / 2.0;
    return speed * (time - ramp_s() / 2.0);
  }
};

/// Returns the distance: three phases of constant jerk up to the speed, then constant speed.
double jerk_limited(double jerk, double time) {
  const double phase = 0.1;
  if (time < phase) return jerk * time * time * time / 6.0;
  const double speed = jerk * phase * phase / 2.0;
  const double place = jerk * phase * phase * phase / 6.0;
  const double since = std::min(time - phase, phase);
  const double there = place + speed * since + jerk * phase * since * since / 2.0 -
                       jerk * since * since * since / 6.0;
  return there + std::max(0.0, time - 2.0 * phase) * 2.0 * speed;
}

TEST(MotionMeter, ConstantSpeedHasNoAcceleration) {
  // Two ramps of 5 mm/s², and 50 mm/s between them. The trace is rounded to 1 ns, which gives an
  // error of 4 v ε / window².
  const Ramps ramps{5.0, 50.0, 600.0};
  const auto meter = measured(
      {}, [&](double t) { return Point{ramps.at(t)}; }, ramps.end_s() + 0.1);
  EXPECT_LE(meter.axis(Axis::kX).greatest_acceleration, 5.0 + 4.0 * 50.0 * 0.7e-9 / 1.0e-4);
  // At the ends the motion is less certain: by a tenth of step / window².
  EXPECT_LT(meter.greatest_path_acceleration(), 5.0 + 0.1 * 125.0);
}

TEST(MotionMeter, ConstantSpeedIsExact) {
  const auto meter = measured(
      {},
      [](double t) {
        return Point{50.0 * t, -20.0 * t};
      },
      1.0);
  EXPECT_NEAR(meter.axis(Axis::kX).greatest_speed, 50.0, 1.0e-4);
  EXPECT_NEAR(meter.axis(Axis::kY).greatest_speed, 20.0, 1.0e-4);
  EXPECT_EQ(meter.axis(Axis::kZ).greatest_speed, 0.0);
  EXPECT_NEAR(meter.greatest_path_speed(), std::hypot(50.0, 20.0), 0.3);
  EXPECT_NEAR(meter.path_length(), std::hypot(50.0, 20.0), 0.03);
  EXPECT_EQ(meter.axis(Axis::kX).steps, 4000U);
  EXPECT_NEAR(meter.axis(Axis::kY).lowest, -20.0, 1.0e-9);
  EXPECT_NEAR(meter.axis(Axis::kX).highest, 50.0, 1.0e-9);
}

TEST(MotionMeter, SeesSuddenStartsAndStops) {
  // 50 mm/s begins and ends without a ramp: over windows of 10 ms, about 5000 mm/s² each.
  const auto course = [](double t) { return Point{50.0 * std::clamp(t - 0.5, 0.0, 0.4)}; };
  const auto meter = measured({}, course, 1.0);
  EXPECT_GT(meter.axis(Axis::kX).greatest_acceleration, 0.9 * 5000.0);
  EXPECT_LE(meter.axis(Axis::kX).greatest_acceleration, 5000.0);
}

TEST(MotionMeter, RampsOfConstantAcceleration) {
  for (const double acceleration : {50.0, 500.0, 3000.0}) {
    const Ramps ramps{acceleration, 100.0, 250.0};
    const auto meter = measured(
        {}, [&](double t) { return Point{ramps.at(t)}; }, ramps.end_s() + 0.1);
    const AxisMotion x = meter.axis(Axis::kX);
    EXPECT_NEAR(x.greatest_speed, 100.0, 1.0e-3);
    EXPECT_NEAR(x.greatest_acceleration / acceleration, 1.0, 1.0e-3) << acceleration;
    EXPECT_NEAR(meter.greatest_path_acceleration(), acceleration, 0.01 * acceleration + 15.0);
  }
}

TEST(MotionMeter, NothingSpuriousAtLowSpeed) {
  // 4 steps a second, with ramps of 1 mm/s². Differences of plain samples of the motor over 10 ms
  // would contain a step in a window, which appears as 125 mm/s².
  const Ramps ramps{1.0, 0.05, 1.0};
  const auto meter = measured(
      {}, [&](double t) { return Point{ramps.at(t)}; }, ramps.end_s() + 1.0);
  EXPECT_LE(meter.axis(Axis::kX).greatest_acceleration, 1.0 + 1.0e-3);
  EXPECT_NEAR(meter.axis(Axis::kX).greatest_speed, 0.05, 1.0e-5);
  EXPECT_LT(meter.greatest_path_acceleration(), 10.0);
}

TEST(MotionMeter, JerkOfThreePhases) {
  // The motion accelerates to 100 mm/s, moves out at that speed, and returns to rest with the same
  // profile.
  const auto course = [](double t) {
    const double way = jerk_limited(10'000.0, 0.5);
    return Point{t < 0.5 ? jerk_limited(10'000.0, t)
                         : 2.0 * way - jerk_limited(10'000.0, std::max(0.0, 1.0 - t))};
  };
  const AxisMotion x = measured({}, course, 1.1).axis(Axis::kX);
  EXPECT_NEAR(x.greatest_speed, 100.0, 0.01);
  // The peak is shorter than two windows.
  EXPECT_NEAR(x.greatest_acceleration / 1000.0, 1.0, 0.06);
  EXPECT_NEAR(x.greatest_jerk / 10'000.0, 1.0, 0.005);
  EXPECT_LE(x.greatest_jerk, 10'000.0 * (1.0 + 1.0e-3));
}

/// Motion around a circle, four revolutions. On the ramps, the tangential acceleration is a
/// twentieth of the centripetal one, which adds a thousandth to the norm.
Ramps round_the_circle(double radius, double speed) {
  return {speed * speed / radius / 20.0, speed, radius * 8.0 * std::numbers::pi};
}

Point on_circle(double radius, double speed, double time) {
  const Ramps ramps = round_the_circle(radius, speed);
  const double angle = ramps.at(time) / radius;
  return {radius * std::cos(angle) - radius, radius * std::sin(angle)};
}

TEST(MotionMeter, CentripetalAccelerationOfCircles) {
  struct Case {
    double radius;
    double speed;
    double steps_per_mm;
    double window_s;
  };
  // If steps are coarse or the circle is small, the window is chosen accordingly.
  for (const Case c : {Case{20.0, 100.0, 80.0, 0.010},
                       Case{20.0, 100.0, 400.0, 0.010},
                       Case{5.0, 50.0, 160.0, 0.010},
                       Case{100.0, 300.0, 80.0, 0.010},
                       Case{1.0, 20.0, 400.0, 0.008}}) {
    SyntheticMachine machine;
    machine.steps_per_mm.fill(c.steps_per_mm);
    const double end = round_the_circle(c.radius, c.speed).end_s() + 0.1;
    const auto meter = measured(machine,
                                [&](double t) { return on_circle(c.radius, c.speed, t); },
                                end,
                                {.course_s = c.window_s});
    const double centripetal = c.speed * c.speed / c.radius;
    EXPECT_NEAR(meter.greatest_path_acceleration() / centripetal, 1.0, 0.01)
        << "R " << c.radius << " v " << c.speed << " steps/mm " << c.steps_per_mm;
    EXPECT_NEAR(meter.greatest_path_speed() / c.speed, 1.0, 0.01);
    EXPECT_NEAR(meter.path_length() / (8.0 * std::numbers::pi * c.radius), 1.0, 0.01);
    // The pulses of one axis prove a lower bound: it is never greater than the true acceleration.
    EXPECT_LE(meter.axis(Axis::kX).greatest_acceleration, centripetal * 1.0001);
    EXPECT_GE(meter.axis(Axis::kX).greatest_acceleration, centripetal * 0.98);
  }
}

TEST(MotionMeter, ErrorsOfTimeAddWhatTheBoundSays) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  const SyntheticMachine machine{.jitter_s = 25.0e-6, .seed = seed};
  const Ramps ramps{500.0, 100.0, 100.0};
  const auto meter = measured(
      machine, [&](double t) { return Point{ramps.at(t)}; }, ramps.end_s() + 0.1);
  const AxisMotion x = meter.axis(Axis::kX);
  EXPECT_LE(x.greatest_speed, 100.0 + 0.5);
  EXPECT_LE(x.greatest_acceleration, 500.0 + 4.0 * 100.0 * 25.0e-6 / 1.0e-4);
}

TEST(MotionMeter, LongPausesCostNothingAndChangeNothing) {
  const Ramps ramps{1000.0, 50.0, 20.0};
  const auto rows =
      SyntheticMachine{}.rows([&](double t) { return Point{ramps.at(t)}; }, ramps.end_s() + 0.1);
  MotionMeter meter{SyntheticMachine{}.steps_per_mm};
  const std::uint64_t hour = 3'600'000'000'000;
  std::int32_t base = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    for (TraceRow row : rows) {
      row.time_ns += i * hour;
      row.position[0] += base;
      meter.on_row(row);
    }
    base += rows.back().position[0];
  }
  meter.on_end(100 * hour);
  EXPECT_NEAR(meter.axis(Axis::kX).greatest_acceleration / 1000.0, 1.0, 0.01);
  EXPECT_NEAR(meter.path_length(), 2000.0, 0.2);
}

}  // namespace
}  // namespace sim
