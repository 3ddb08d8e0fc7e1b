#include "tests/support/motion_judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/random_source.hpp"

namespace sim {
namespace {

constexpr double kWindow = 0.01;  // s

/// Builds a plan from successive pieces of constant acceleration.
class PlanWriter {
 public:
  PlanWriter& go(double duration, double acceleration) {
    pieces_.push_back({duration, place_, speed_, acceleration});
    place_ = pieces_.back().place_after(duration);
    speed_ = pieces_.back().speed_after(duration);
    return *this;
  }
  [[nodiscard]] FilteredPlan plan(double window = kWindow) const {
    return FilteredPlan{pieces_, window};
  }

 private:
  std::vector<PlanPiece> pieces_;
  double place_ = 0.0;
  double speed_ = 0.0;
};

/// Returns a plan of 20 mm: 0.1 s up to 100 mm/s, 0.1 s at this speed, 0.1 s down to rest.
PlanWriter trapezoid() {
  PlanWriter writer;
  writer.go(0.1, 1000.0).go(0.1, 0.0).go(0.1, -1000.0);
  return writer;
}

MotionLimits judge_limits() {
  MotionLimits limits;
  limits.rate.fill(100.0);
  limits.acceleration.fill(1000.0);
  limits.jerk.fill(1.0e5);
  return limits;
}

MotionFigures judge(const std::string& program, const PlanWriter& plan) {
  return judge_motion(plan.plan(), read_program(program), judge_limits());
}

TEST(FilteredPlan, IsTheMeanOverTheWindow) {
  const FilteredPlan plan = trapezoid().plan();
  EXPECT_DOUBLE_EQ(plan.seconds(), 0.31);
  // At first the acceleration rises by A / T = 1e5 mm/s³.
  EXPECT_NEAR(plan.at(0.005).place, 1.0e5 * std::pow(0.005, 3) / 6.0, 1e-15);
  EXPECT_NEAR(plan.at(0.005).speed, 1.25, 1e-12);
  EXPECT_NEAR(plan.at(0.005).acceleration, 500.0, 1e-9);
  EXPECT_NEAR(plan.at(0.005).jerk, 1.0e5, 1e-6);
  // With constant acceleration, the mean is the position half a window earlier plus A T² / 24.
  const double middle = 0.05 - 0.005;
  EXPECT_NEAR(plan.at(0.05).place, 500.0 * middle * middle + 1000.0 * 1.0e-4 / 24.0, 1e-12);
  EXPECT_NEAR(plan.at(0.05).jerk, 0.0, 1e-9);
  EXPECT_NEAR(plan.at(0.31).place, 20.0, 1e-12);
  EXPECT_NEAR(plan.at(9.0).place, 20.0, 1e-12);
  EXPECT_EQ(plan.at(-1.0).place, 0.0);
}

TEST(FilteredPlan, DerivativesBelongToEachOther) {
  PlanWriter writer;
  proof::Random random{20261121};
  double speed = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double duration = random.magnitude(1.0e-4, 0.03);
    const double wanted = random.between(1.0, 100.0);
    const double next = i == 199 ? 0.0 : wanted;
    writer.go(duration, (next - speed) / duration);
    speed = next;
  }
  const FilteredPlan plan = writer.plan();
  const std::vector<double> times = plan.breakpoints();
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const double h = times[i + 1] - times[i];
    if (h < 1.0e-6) continue;
    const PathState from = plan.at(times[i]);
    const PathState to = plan.at(times[i + 1]);
    // The position is a cubic between two breakpoints.
    const double j = plan.at(times[i] + 0.5 * h).jerk;
    const double place =
        from.place + ((j * h / 6.0 + from.acceleration / 2.0) * h + from.speed) * h;
    ASSERT_NEAR(to.place, place, 1e-10) << "time " << times[i];
    ASSERT_NEAR(to.speed, from.speed + (j * h / 2.0 + from.acceleration) * h, 1e-8);
    ASSERT_NEAR(to.acceleration, from.acceleration + j * h, 1e-6);
  }
}

TEST(FilteredPlan, GapsAreFound) {
  const FilteredPlan plan{{{0.1, 0.0, 0.0, 1000.0}, {0.1, 5.25, 99.0, 0.0}}, kWindow};
  EXPECT_NEAR(plan.greatest_gap().place, 0.25, 1e-12);
  EXPECT_NEAR(plan.greatest_gap().speed, 99.0, 1e-12) << "it ends at 99 mm/s";
}

TEST(MotionJudge, AMoveAtEveryLimit) {
  const MotionFigures figures = judge("G1 X20 F6000\n", trapezoid());
  EXPECT_NEAR(figures.rate.value, 1.0, 1e-9);
  EXPECT_NEAR(figures.feed.value, 1.0, 1e-9);
  EXPECT_NEAR(figures.acceleration.value, 1.0, 1e-9);
  EXPECT_NEAR(figures.jerk.value, 1.0, 1e-9);
  EXPECT_EQ(figures.turn.value, 0.0);
  EXPECT_NEAR(figures.end_error, 0.0, 1e-12);
}

TEST(MotionJudge, EachAxisGetsItsShare) {
  // A 3-4-5 triangle: Y has 0.8 of speed, acceleration and jerk.
  const MotionFigures figures = judge("G1 X12 Y16 F60000\n", trapezoid());
  EXPECT_NEAR(figures.rate.value, 0.8, 1e-9);
  EXPECT_NEAR(figures.jerk.value, 0.8, 1e-9);
  EXPECT_EQ(figures.jerk.axis, 1U);
}

TEST(MotionJudge, ASteadyCircle) {
  PlanWriter writer;
  writer.go(6.0, 10.0).go(4.0, 0.0).go(6.0, -10.0);
  const MotionFigures figures =
      judge_motion(writer.plan(1.0), read_program("G3 I10 P10 F60000\n"), judge_limits());
  // v²/R and v³/R² at 60 mm/s.
  EXPECT_NEAR(figures.acceleration.value, 360.0 / 1000.0, 1e-6);
  EXPECT_NEAR(figures.jerk.value, 2160.0 / 1.0e5, 1e-2 * 2160.0 / 1.0e5);
  EXPECT_NEAR(figures.rate.value, 0.6, 1e-6);
  EXPECT_NEAR(figures.step.value, 0.0, 1e-9) << "between the halves of a circle";
}

TEST(MotionJudge, AxisJerkIsTheThirdDerivativeOfThePlace) {
  // The plan speeds up on a helix and changes its acceleration once. Differences of positions
  // verify the figures.
  PlanWriter writer;
  writer.go(0.2, 200.0).go(0.05, 0.0).go(0.05, 300.0);
  const FilteredPlan plan = writer.plan(0.05);
  const ProgrammedPath path = read_program("G3 X20 Y0 Z9 I10 J0 F60000\n");
  const Curve& curve = path.pieces[0].curve;
  const double time = 0.26;
  constexpr double kStep = 1.0e-3;
  const PathState state = plan.at(time);
  const double fraction = state.place / curve.length();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto place = [&](double k) {
      return curve.point_at(plan.at(time + k * kStep).place / curve.length())[axis];
    };
    const double measured =
        (place(1.5) - 3.0 * place(0.5) + 3.0 * place(-0.5) - place(-1.5)) / (kStep * kStep * kStep);
    const double v = state.speed;
    const double expected = curve.tangent_at(fraction)[axis] * state.jerk +
                            3.0 * curve.curvature_at(fraction)[axis] * v * state.acceleration +
                            curvature_rate_at(curve, fraction)[axis] * v * v * v;
    EXPECT_NEAR(measured, expected, 1e-3 * state.jerk) << "axis " << axis;
  }
}

TEST(MotionJudge, TheStepOfTheNormalAccelerationIsNoJerk) {
  // The plan reaches the arc at 40 mm/s: the normal acceleration steps from 0 to 40²/4 = 400 mm/s².
  PlanWriter writer;
  const double way = 20.0 + 4.0 * std::numbers::pi / 2.0 + 20.0;
  writer.go(0.4, 100.0).go((way - 16.0) / 40.0, 0.0).go(0.4, -100.0);
  const MotionFigures figures = judge("F60000 G1 X20\nG3 X24 Y4 J4\nG1 Y24\n", writer);
  EXPECT_NEAR(figures.step.value, 0.4, 1e-9);
  EXPECT_NEAR(figures.turn.value, 0.0, 1e-9);
  EXPECT_NEAR(figures.jerk.value, 0.1, 1e-9) << "at the start; v³/R² is 0.04";
}

TEST(MotionJudge, PlantedViolationsAreFoundWhereTheyAre) {
  PlanWriter fast;
  fast.go(0.11, 1000.0).go(0.07, 0.0).go(0.11, -1000.0);
  const MotionFigures speed = judge("G1 X100 F60000\n", fast);
  EXPECT_NEAR(speed.rate.value, 1.1, 1e-9);
  EXPECT_GE(speed.rate.time, 0.12 - 1e-9) << "when the window has left the ramp";
  EXPECT_GT(speed.end_error, 70.0);

  PlanWriter strong;
  strong.go(0.1, 1000.0).go(0.1, 0.0).go(0.08, -1250.0);
  const MotionFigures acceleration = judge("G1 X19 F6000\n", strong);
  EXPECT_NEAR(acceleration.acceleration.value, 1.25, 1e-9);
  EXPECT_NEAR(acceleration.jerk.value, 1.25, 1e-9);
  EXPECT_NEAR(acceleration.jerk.time, 0.2, 1e-9);
  EXPECT_NEAR(acceleration.jerk.place, 14.5, 1e-9);

  const MotionFigures short_window =
      judge_motion(trapezoid().plan(0.005), read_program("G1 X20 F6000\n"), judge_limits());
  EXPECT_NEAR(short_window.jerk.value, 2.0, 1e-9);
}

TEST(MotionJudge, TurningFromSpeedingUpToBrakingTakesTwiceTheJerk) {
  PlanWriter peak;
  peak.go(0.1, 1000.0).go(0.1, -1000.0);
  const MotionFigures figures = judge("G1 X10 F6000\n", peak);
  EXPECT_NEAR(figures.jerk.value, 2.0, 1e-9);
  EXPECT_NEAR(figures.jerk.time, 0.1, 1e-9);
  PlanWriter plateau;
  plateau.go(0.1, 1000.0).go(kWindow, 0.0).go(0.1, -1000.0);
  EXPECT_NEAR(judge("G1 X11 F6000\n", plateau).jerk.value, 1.0, 1e-9);
}

TEST(MotionJudge, AStopThatIsDrivenThroughAndACornerAreFound) {
  const MotionFigures stop = judge("F6000 G1 X10\nG4 P0\nX20\n", trapezoid());
  EXPECT_NEAR(stop.stop.value, 100.0, 1e-9);
  EXPECT_EQ(stop.stop.piece, 1U);
  const MotionFigures corner = judge("F6000 G1 X10\nY10\n", trapezoid());
  EXPECT_NEAR(corner.turn.value, 100.0, 1e-9);
  EXPECT_NEAR(corner.turn.place, 10.0, 1e-9);
  EXPECT_NEAR(corner.turn.time, 0.155, 1e-9) << "half a window behind the plan";
}

TEST(MotionJudge, AChangeOfAccelerationOnAShortArcIsSeen) {
  // The term v a t′: a ramp on an arc of 1 mm.
  PlanWriter writer;
  const double way = 0.5 * std::numbers::pi;
  writer.go(std::sqrt(way / 1000.0), 1000.0).go(std::sqrt(way / 1000.0), -1000.0);
  const MotionFigures figures = judge("G3 X1 Y1 J1 F60000\n", writer);
  EXPECT_GT(figures.acceleration.value, 1.3) << "both axes share a and v²/R";
  EXPECT_GT(figures.jerk.value, 1.0);
}

}  // namespace
}  // namespace sim
