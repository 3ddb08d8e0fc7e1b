// Tests words and positions under G43.4, and the travel of the axes.

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "firmware/machine/configuration.hpp"
#include "firmware/machine/travel.hpp"
#include "host-sim/machine/five_axis_model.hpp"
#include "host-sim/machine/simulator.hpp"
#include "tests/support/five_axis_places.hpp"
#include "tests/support/random_five_axes.hpp"
#include "tests/support/trials.hpp"

namespace proof::five_axes {
namespace {

using cnc::kinematics::ToolCentre;
using sim::FiveAxisModel;

/// Runs a program on a machine with tables on A and C whose A axis lies 50 mm below the origin.
class TablesJob {
 public:
  explicit TablesJob(const std::string& program) : simulator_{program, {}} {
    for (const auto& [number, value] :
         std::vector<std::pair<int, float>>{{900, 1.0F}, {912, -50.0F}, {915, -50.0F}}) {
      EXPECT_EQ(simulator_.change_setting(static_cast<std::uint16_t>(number), value), "");
    }
    result_ = simulator_.run();
  }

  [[nodiscard]] const sim::RunResult& result() const { return result_; }
  [[nodiscard]] double axis(std::size_t index) const {
    const double scale = index < cnc::kLinearAxisCount ? 250.0 : 100.0;
    return result_.final_position[index] / scale;
  }
  [[nodiscard]] int first_refusal() const {
    return result_.refusals.empty() ? 0 : static_cast<int>(result_.refusals.front().number);
  }

 private:
  sim::Simulator simulator_;
  sim::RunResult result_;
};

TEST(FiveAxes, ATipThatStandsStillIsDrivenAroundByItsTables) {
  // The point is 30 mm from the axis of C and 50 mm above that of A. A quarter turn of C takes it
  // to Y -30; a quarter turn of A lowers it.
  const TablesJob turned{"G21 G90 G94\nG0 X30 Y0 Z0\nG43.4\nG1 C90 F3000\nG49\n"};
  ASSERT_TRUE(turned.result().refusals.empty());
  EXPECT_NEAR(turned.axis(0), 0.0, 0.01);
  EXPECT_NEAR(turned.axis(1), -30.0, 0.01);
  EXPECT_NEAR(turned.axis(2), 0.0, 0.01);
  const TablesJob tilted{"G21 G90 G94\nG0 X30 Y0 Z0\nG43.4\nG1 A90 F3000\nG49\n"};
  EXPECT_NEAR(tilted.axis(0), 30.0, 0.01);
  EXPECT_NEAR(tilted.axis(1), 50.0, 0.01);
  EXPECT_NEAR(tilted.axis(2), -50.0, 0.01);
}

TEST(FiveAxes, AfterG49WordsAreThoseOfTheAxesAgain) {
  const TablesJob job{"G21 G90 G94\nG0 X30\nG43.4\nG1 C90 F3000\nG49\nG1 X10\n"};
  ASSERT_TRUE(job.result().refusals.empty());
  EXPECT_NEAR(job.axis(0), 10.0, 0.01);
  EXPECT_NEAR(job.axis(1), -30.0, 0.01);
}

TEST(FiveAxes, AToolLengthRaisesTheAxesAlongTheTool) {
  const TablesJob job{"G21 G90 G94\nG43.4 Z20\nG1 X0 Y0 Z0 A90 F3000\nG49\n"};
  ASSERT_TRUE(job.result().refusals.empty());
  // After the tilt the tip is 50 mm beside the axis of A, and the gauge point is 20 mm above the
  // tip.
  EXPECT_NEAR(job.axis(1), 50.0, 0.01);
  EXPECT_NEAR(job.axis(2), -50.0 + 20.0, 0.01);
}

TEST(FiveAxes, WordsThatMoveTheAxesThemselvesAreRefused) {
  for (const char* const line : {"G28",
                                 "G30",
                                 "G28.1",
                                 "G53 G0 X0",
                                 "G38.2 X10 F100",
                                 "M6 T1",
                                 "G41.1 D1",
                                 "G5 I1 J1 P1 Q1 X5 Y5",
                                 "G5.2 X1 Y1 P1"}) {
    const TablesJob job{fmt::format("G21 G90 G94 F100\nG43.4\n{}\n", line)};
    EXPECT_EQ(job.first_refusal(), 20) << line;
  }
  EXPECT_EQ(TablesJob{"G21 G90\nG43.4\nG49 G0 X1\n"}.first_refusal(), 31);
  EXPECT_EQ(TablesJob{"G21 G90\nG43.4 X1\n"}.first_refusal(), 37);
  EXPECT_EQ(TablesJob{"G21 G90\nG43.4\nG49\nG28.1\n"}.first_refusal(), 0);
}

/// Tallies of verdicts on the travel of the axes, compared with dense samples of the model.
struct TravelTally {
  int inside = 0;
  int refused = 0;
  /// Greatest excess over the travel of an accepted motion, mm.
  double farthest_inside_mm = -1.0e9;
  double nearest_refused_mm = 1.0e9;  ///< Least excess over the travel of a refused motion, mm.
};

/// Returns the distance by which the axes X Y Z exceed a travel of 300 mm below 0, mm; negative
/// inside.
double beyond_travel(const FiveAxisModel& model, const Point& from, const Point& to) {
  constexpr int kLooks = 2000;
  constexpr double kTravel = 300.0;
  double greatest = -kTravel;
  for (int look = 0; look <= kLooks; ++look) {
    Point place = from;
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      place[axis] += (to[axis] - from[axis]) * look / kLooks;
    }
    const Point axes = model.axes_for(place);
    for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
      greatest = std::max({greatest, axes[axis], -kTravel - axes[axis]});
    }
  }
  return greatest;
}

void judge_travel(Random& random, int kind, TravelTally& tally) {
  std::vector<std::pair<int, double>> values = random_five_axes(random, kind);
  values.insert(values.end(), {{20, 1}, {132, 300}});
  const cnc::Settings settings = settings_of(values);
  const ToolCentre centre{cnc::rotary_machine_from(settings), {}};
  const FiveAxisModel model{settings, 0.0};
  cnc::Travel travel;
  travel.set_homed(0x07, settings);
  cnc::gcode::Action action{.kind = cnc::gcode::ActionKind::kLine};
  Position from;
  for (std::size_t axis = 0; axis < from.size(); ++axis) {
    const bool turns = axis >= cnc::kLinearAxisCount;
    const double least = turns ? -60.0 : -299.0;
    const double most = turns ? 60.0 : -1.0;
    from[axis] = Coordinate{std::llround(1.0e6 * random.between(least, most))};
    action.end[axis] =
        from[axis] + Coordinate{std::llround(1.0e6 * random.between(-50.0, turns ? 50.0 : 10.0))};
  }
  const cnc::motion::Limits limits = cnc::limits_from(settings);
  cnc::ActionElements elements;
  const bool refused = travel.left_by({&action, 1}, from, {centre, limits}, elements);
  const double beyond = beyond_travel(model, point_of(from), point_of(action.end));
  if (refused) {
    ++tally.refused;
    tally.nearest_refused_mm = std::min(tally.nearest_refused_mm, beyond);
  } else {
    ++tally.inside;
    tally.farthest_inside_mm = std::max(tally.farthest_inside_mm, beyond);
  }
}

TEST(FiveAxes, MotionsThatTakeTheAxesOutOfTheTravelAreRefusedBeforeTheyMove) {
  TravelTally tally;
  const Trials trials{3000};
  for (const std::uint64_t seed : trials) {
    Random random{seed};
    judge_travel(random, 1 + static_cast<int>(seed % kKinds), tally);
  }
  std::printf("%d inside, the farthest %.4f mm beyond; %d refused, the nearest %.4f mm beyond\n",
              tally.inside,
              tally.farthest_inside_mm,
              tally.refused,
              tally.nearest_refused_mm);
  EXPECT_LT(tally.farthest_inside_mm, 2.0e-3);
  EXPECT_GT(tally.nearest_refused_mm, -0.2);
  if (!trials.judges_shares()) return;
  EXPECT_GT(tally.inside, 100);
  EXPECT_GT(tally.refused, 100);
}

TEST(FiveAxes, NeedAMachineThatHasThem) {
  sim::Simulator simulator{"G43.4\n", {}};
  const sim::RunResult result = simulator.run();
  ASSERT_EQ(result.refusals.size(), 1U);
  EXPECT_EQ(result.refusals.front().number, 20);
}

}  // namespace
}  // namespace proof::five_axes
