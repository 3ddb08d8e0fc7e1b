// Tests doors, holds and resets under G43.4, tool centre point control.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "host-sim/machine/five_axis_model.hpp"
#include "tests/support/five_axis_places.hpp"
#include "tests/support/machine_bench.hpp"

namespace proof::five_axes {
namespace {

/// A laser whose beam is sampled each millisecond, with the position of the tip on the part.
class LitJob : public MachineBench {
 public:
  explicit LitJob(int kind) {
    set({{900, kind}, {911, -20.0}, {912, -60.0}, {914, 15.0}, {915, -45.0}, {32, 1}});
    for (int axis = 3; axis < 6; ++axis) {
      set({{cnc::setting::kStepsPerMm + axis, 1000.0}, {cnc::setting::kRate + axis, 4000.0}});
    }
  }

  /// Samples the beam until nothing moves any more, at most `milliseconds`.
  void watch(int milliseconds) {
    while (milliseconds-- > 0) {
      controller.turn();
      if (controller.port().power > 0) lit_.push_back(tip());
    }
  }

  /// Returns the positions of the tip with the beam on, sorted by X.
  [[nodiscard]] std::vector<Point> lit_by_x() const {
    std::vector<Point> lit = lit_;
    std::ranges::sort(lit, [](const Point& a, const Point& b) { return a[0] < b[0]; });
    return lit;
  }

 private:
  [[nodiscard]] Point tip() {
    cnc::AxisArray<cnc::StepPosition> steps{};
    for (std::size_t axis = 0; axis < steps.size(); ++axis) {
      steps[axis] = cnc::StepPosition::whole(motor(axis));
    }
    const cnc::Settings& settings = machine().settings();
    return sim::FiveAxisModel{settings, 0.0}.program_for(point_of(steps, settings));
  }

  std::vector<Point> lit_;
};

TEST(FiveAxes, ADoorAndAHoldLeaveNothingUncut) {
  for (int kind = 1; kind <= kKinds; ++kind) {
    for (const bool has_door : {true, false}) {
      SCOPED_TRACE(testing::Message() << "$900=" << kind << " door " << has_door);
      LitJob job{kind};
      job.send("G21 G90 G94");
      job.send("G43.4");
      job.send("M4 S1000 F1200");
      job.send("G1 X20 Y10 A25 B25 C40");
      job.watch(400);
      if (has_door) {
        job.machine().safety_door();
      } else {
        job.machine().feed_hold();
      }
      job.watch(800);
      job.machine().resume();
      job.watch(12'000);
      ASSERT_TRUE(job.machine().idle());
      const std::vector<Point> lit = job.lit_by_x();
      ASSERT_GT(lit.size(), 100U);
      EXPECT_LT(lit.front()[0], 0.2);
      EXPECT_GT(lit.back()[0], 19.8);
      const Point end{20.0, 10.0, 0.0, 0.0, 0.0, 0.0};
      for (std::size_t i = 0; i < lit.size(); ++i) {
        // A step is 0.004 mm, and 0.001 degrees are 0.002 mm at a lever of 0.1 m.
        EXPECT_LT(off_line(lit[i], {}, end), 0.02);
        if (i == 0) continue;
        EXPECT_LT(lit[i][0] - lit[i - 1][0], 0.1) << lit[i][0];
      }
    }
  }
}

TEST(FiveAxes, AResetLeavesTheAxesWhereTheyAre) {
  LitJob job{1};
  job.send("G21 G90 G94");
  job.send("G43.4");
  job.send("G1 X20 Y10 A25 C40 F1200");
  job.finish();
  const auto steps = job.controller.port().position;
  job.machine().reset();
  job.run(20);
  EXPECT_FALSE(job.machine().interpreter().state().tool_centre);
  for (std::size_t axis = 0; axis < 6; ++axis) {
    const double scale = axis < 3 ? 250.0 : 1000.0;
    EXPECT_NEAR(job.mm(axis), steps[axis] / scale, 1.0e-6) << "places are those of the axes";
  }
  job.send("G91 G1 X1 F600");
  job.finish();
  EXPECT_EQ(job.motor(0), steps[0] + 250);
  EXPECT_EQ(job.motor(1), steps[1]);
  EXPECT_EQ(job.motor(5), steps[5]);
}

}  // namespace
}  // namespace proof::five_axes
