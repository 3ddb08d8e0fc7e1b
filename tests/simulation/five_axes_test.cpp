// G43.4 against a model of the machine in double precision that shares no formula with it.

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "firmware/machine/configuration.hpp"
#include "firmware/machine/travel.hpp"
#include "host-sim/machine/five_axis_model.hpp"
#include "host-sim/machine/simulator.hpp"
#include "tests/support/machine_bench.hpp"
#include "tests/support/random_five_axes.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::Coordinate;
using cnc::Position;
using cnc::kinematics::ToolCentre;
using sim::FiveAxisModel;
using sim::Point;

constexpr int kKinds = 6;  ///< Of $900, from 1 on.

Point point_of(const Position& place) {
  Point point{};
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    point[axis] = static_cast<double>(place[axis].nanometres()) * 1.0e-6;
  }
  return point;
}

Point point_of(const cnc::AxisArray<cnc::StepPosition>& steps, const cnc::Settings& settings) {
  Point point{};
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    const auto scale = static_cast<double>(settings.get(cnc::setting::kStepsPerMm, axis));
    point[axis] = std::ldexp(static_cast<double>(steps[axis].q32()), -32) / scale;
  }
  return point;
}

double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

cnc::Settings settings_of(const std::vector<std::pair<int, double>>& values) {
  cnc::Settings settings;
  for (const auto& [number, value] : values) {
    EXPECT_TRUE(settings.set(static_cast<std::uint16_t>(number), static_cast<float>(value)).ok());
  }
  return settings;
}

Position random_place(Random& random, double rotary_deg) {
  Position place;
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    const double most = axis < cnc::kLinearAxisCount ? 300.0 : rotary_deg;
    place[axis] = Coordinate{std::llround(1.0e6 * random.between(-most, most))};
  }
  return place;
}

/// Greatest differences between the controller's formulas and the model, mm.
struct Differences {
  double forwards = 0.0;
  double backwards = 0.0;
  double in_steps = 0.0;
  double direction = 0.0;  ///< rad
};

void compare(Random& random, int kind, Differences& greatest) {
  const cnc::Settings settings = settings_of(random_five_axes(random, kind));
  const Coordinate length{std::llround(1.0e6 * random.between(0.0, 100.0))};
  const ToolCentre centre{cnc::rotary_machine_from(settings), length};
  const FiveAxisModel model{settings, static_cast<double>(length.nanometres()) * 1.0e-6};
  const auto scale = cnc::limits_from(settings).scale;
  for (int place = 0; place < 20; ++place) {
    const Position program = random_place(random, place % 2 == 0 ? 180.0 : 100'000.0);
    const Position axes = centre.axes_for(program);
    greatest.forwards =
        std::max(greatest.forwards, distance(model.program_for(point_of(axes)), point_of(program)));
    greatest.backwards = std::max(
        greatest.backwards,
        distance(point_of(centre.program_for(program)), model.program_for(point_of(program))));
    const cnc::Vec3 direction = centre.direction(program);
    const Eigen::Vector3d wanted = model.tool_at(point_of(program)).axis;
    greatest.direction = std::max(greatest.direction, (direction.cast<double>() - wanted).norm());
    cnc::AxisArray<cnc::StepPosition> steps{};
    for (std::size_t axis = 0; axis < steps.size(); ++axis) {
      steps[axis] = *scale[axis].steps_at(program[axis]);
    }
    greatest.in_steps =
        std::max(greatest.in_steps,
                 distance(model.program_for(point_of(centre.axes_for(steps, scale), settings)),
                          point_of(steps, settings)));
  }
}

TEST(FiveAxes, PlacesAreThoseOfTheChainInDoublePrecision) {
  const Trials trials{2000};
  Differences greatest;
  for (const std::uint64_t seed : trials) {
    Random random{seed};
    compare(random, 1 + static_cast<int>(seed % kKinds), greatest);
  }
  std::printf("levers up to 0.8 m: %.3f, %.3f, %.3f um; direction %.2e rad\n",
              1.0e3 * greatest.forwards,
              1.0e3 * greatest.backwards,
              1.0e3 * greatest.in_steps,
              greatest.direction);
  EXPECT_LT(greatest.forwards, 1.0e-3);
  EXPECT_LT(greatest.backwards, 1.0e-3);
  EXPECT_LT(greatest.in_steps, 1.0e-3);
  EXPECT_LT(greatest.direction, 2.0e-6);
}

/// The knots that the motors go through, one for each cell of time.
class Knots final : public cnc::motion::ShapingObserver {
 public:
  void on_cell(const cnc::motion::ShapedCell& cell) override { places.push_back(cell.planned); }

  std::vector<cnc::AxisArray<cnc::StepPosition>> places;
};

constexpr double kCellS = 1.0e-3;

/// Distance of a place from a straight way, over X Y Z, mm.
double off_line(const Point& place, const Point& from, const Point& to) {
  const Eigen::Vector3d a{from[0], from[1], from[2]};
  const Eigen::Vector3d b{to[0], to[1], to[2]};
  const Eigen::Vector3d p{place[0], place[1], place[2]};
  const double length_square = (b - a).squaredNorm();
  const double share =
      length_square > 0.0 ? std::clamp((p - a).dot(b - a) / length_square, 0.0, 1.0) : 0.0;
  return (p - (a + share * (b - a))).norm();
}

/// Greatest figures of motions, as shares of their limits where one is known.
struct MotionFigures {
  double off_line_mm = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
  double feed = 0.0;
  double least_feed = 1.0;  ///< The greatest feed of the motion that came least near to its own.
  double steps_mm = 0.0;    ///< From the end of a motion to where whole steps leave the tip.
};

/// A machine that drives one straight motion of the tip after the other.
class FiveAxisJob : public MachineBench {
 public:
  FiveAxisJob(Random& random, int kind) {
    set(random_five_axes(random, kind));
    for (int axis = 0; axis < 3; ++axis) {
      set({{cnc::setting::kStepsPerMm + axis, 400.0},
           {cnc::setting::kRate + axis, random.magnitude(1000.0, 20'000.0)},
           {cnc::setting::kAcceleration + axis, random.magnitude(100.0, 4000.0)}});
    }
    for (int axis = 3; axis < 6; ++axis) {
      set({{cnc::setting::kRate + axis, random.magnitude(1000.0, 20'000.0)},
           {cnc::setting::kAcceleration + axis, random.magnitude(100.0, 4000.0)}});
    }
    tool_length_ = std::round(1.0e3 * random.between(0.0, 100.0)) * 1.0e-3;
    send("G90 G21 G94 G61.1");
    send(fmt::format("G43.4 Z{:.3f}", tool_length_));
    finish();
    machine().observe(&knots_);
  }

  /// Drives to a place and measures the motion there.
  void drive(const std::string& words, MotionFigures& figures) {
    knots_.places.clear();
    const Point from = point_of(machine().interpreter().position());
    const auto feed = static_cast<double>(machine().interpreter().state().feed);
    send(words);
    finish();
    const Point to = point_of(machine().interpreter().position());
    measure(from, to, feed, figures);
    // Motors stand on whole steps: half of one of 0.01 degrees is 0.06 mm at 0.7 m.
    figures.steps_mm = std::max(figures.steps_mm, distance(tip(), to));
  }

  [[nodiscard]] Point tip() {
    cnc::AxisArray<cnc::StepPosition> steps{};
    for (std::size_t axis = 0; axis < steps.size(); ++axis) {
      steps[axis] = cnc::StepPosition::whole(motor(axis));
    }
    return program_of(steps);
  }

 private:
  [[nodiscard]] Point program_of(const cnc::AxisArray<cnc::StepPosition>& steps) {
    const cnc::Settings& settings = machine().settings();
    return FiveAxisModel{settings, tool_length_}.program_for(point_of(steps, settings));
  }

  void measure(const Point& from, const Point& to, double feed, MotionFigures& figures) {
    const cnc::Settings& settings = machine().settings();
    double greatest_feed = 0.0;
    for (std::size_t i = 0; i < knots_.places.size(); ++i) {
      const Point here = program_of(knots_.places[i]);
      figures.off_line_mm = std::max(figures.off_line_mm, off_line(here, from, to));
      constexpr std::size_t kCells = 10;  // Rounding has no part in so long a way.
      if (i >= kCells) {
        const Point before = program_of(knots_.places[i - kCells]);
        constexpr double kRounding = 4.0e-4;
        greatest_feed =
            std::max(greatest_feed, (distance(here, before) - kRounding) / (kCells * kCellS));
      }
      if (i == 0) continue;
      for (std::size_t axis = 0; axis < here.size(); ++axis) {
        measure_axis(i, axis, settings, figures);
      }
    }
    if (feed > 0.0) {
      figures.feed = std::max(figures.feed, greatest_feed / feed);
      figures.least_feed = std::min(figures.least_feed, greatest_feed / feed);
    }
  }

  void measure_axis(std::size_t i,
                    std::size_t axis,
                    const cnc::Settings& settings,
                    MotionFigures& figures) const {
    const auto at = [&](std::size_t cell) { return point_of(knots_.places[cell], settings)[axis]; };
    const auto limit = [&](std::uint16_t first) {
      return static_cast<double>(settings.get(first, axis));
    };
    // Over some cells, because single precision moves each knot by up to 0.3 um.
    constexpr std::size_t kSpan = 5;
    constexpr double kRounding = 3.0e-4;
    const double rounding = axis < cnc::kLinearAxisCount ? kRounding : 0.0;
    if (i < 2 * kSpan) return;
    const double way = at(i) - at(i - kSpan);
    const double change = way - (at(i - kSpan) - at(i - 2 * kSpan));
    const double seconds = kSpan * kCellS;
    figures.rate =
        std::max(figures.rate,
                 (std::abs(way) - 2.0 * rounding) / seconds / (limit(cnc::setting::kRate) / 60.0));
    figures.acceleration = std::max(figures.acceleration,
                                    (std::abs(change) - 4.0 * rounding) / (seconds * seconds) /
                                        limit(cnc::setting::kAcceleration));
  }

  double tool_length_ = 0.0;
  Knots knots_;
};

/// A line of the tip by up to some hundred millimetres, with its rotary axes.
std::string random_motion(Random& random, double most_turn_deg) {
  std::string words = fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f}",
                                  random.between(-80.0, 80.0),
                                  random.between(-80.0, 80.0),
                                  random.between(-40.0, 40.0));
  return words + fmt::format(" {}{:.3f} C{:.3f}",
                             "AB"[random.below(2)],
                             random.between(-90.0, 90.0),
                             random.between(-most_turn_deg, most_turn_deg));
}

TEST(FiveAxes, TheTipStaysOnItsLineAndAxesKeepTheirLimits) {
  const Trials trials{48};
  for (int kind = 1; kind <= kKinds; ++kind) {
    MotionFigures figures;
    for (const std::uint64_t seed : trials) {
      if (static_cast<int>(seed % kKinds) + 1 != kind) continue;
      SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
      Random random{seed};
      FiveAxisJob job{random, kind};
      job.send(fmt::format("F{:.1f}", random.magnitude(500.0, 6000.0)));
      for (int move = 0; move < 4; ++move) job.drive(random_motion(random, 360.0), figures);
    }
    std::printf(
        "kind %d: off its line %.3f um (in whole steps %.1f um), rate %.4f, acceleration %.4f, "
        "feed "
        "%.4f to %.4f\n",
        kind,
        1.0e3 * figures.off_line_mm,
        1.0e3 * figures.steps_mm,
        figures.rate,
        figures.acceleration,
        figures.least_feed,
        figures.feed);
    EXPECT_LT(figures.off_line_mm, 1.0e-3);
    EXPECT_LT(figures.steps_mm, 0.1);
    EXPECT_LT(figures.rate, 1.001);
    EXPECT_LT(figures.acceleration, 1.01);
    EXPECT_LT(figures.feed, 1.001);
  }
}

TEST(FiveAxes, TheTipHasTheProgrammedFeedWhereNoAxisIsTooSlow) {
  for (int kind = 1; kind <= kKinds; ++kind) {
    Random random{static_cast<std::uint64_t>(kind)};
    FiveAxisJob job{random, kind};
    for (int axis = 0; axis < 6; ++axis) {
      job.set(
          {{cnc::setting::kRate + axis, 60'000.0}, {cnc::setting::kAcceleration + axis, 20'000.0}});
    }
    job.send("F600");
    MotionFigures figures;
    for (int move = 0; move < 4; ++move) job.drive(random_motion(random, 60.0), figures);
    std::printf("kind %d: feed %.4f to %.4f\n", kind, figures.least_feed, figures.feed);
    EXPECT_GT(figures.least_feed, 0.99);
    EXPECT_LT(figures.feed, 1.001);
  }
}

/// A laser whose light is looked at each millisecond, where the part sees the tip.
class LitJob : public MachineBench {
 public:
  explicit LitJob(int kind) {
    set({{900, kind}, {911, -20.0}, {912, -60.0}, {914, 15.0}, {915, -45.0}, {32, 1}});
    for (int axis = 3; axis < 6; ++axis) {
      set({{cnc::setting::kStepsPerMm + axis, 1000.0}, {cnc::setting::kRate + axis, 4000.0}});
    }
  }

  /// Watches the light until nothing more happens, at most some seconds.
  void watch(int milliseconds) {
    while (milliseconds-- > 0) {
      controller.turn();
      if (controller.port().power > 0) lit_.push_back(tip());
    }
  }

  /// Places of the tip with light, by their X.
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
    return FiveAxisModel{settings, 0.0}.program_for(point_of(steps, settings));
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

/// Runs a program on a machine with tables for A and C, 50 mm under the origin.
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
  // The point 30 mm beside C and 50 mm above A's axis, turned by a quarter about C: the tables take
  // it to Y -30; by another about A it would be below.
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
  // The tip is 50 mm beside A's axis after the tilt, and the gauge point 20 mm above it.
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

/// Verdicts on the travel of the axes, beside a dense look by the model.
struct TravelTally {
  int inside = 0;
  int refused = 0;
  double farthest_inside_mm = -1.0e9;  ///< Beyond the travel, of a motion that was taken.
  double nearest_refused_mm = 1.0e9;   ///< The same of one that was refused.
};

/// How far the axes X Y Z come beyond a travel of 300 mm below 0, mm; below 0 inside.
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
  travel.configure(settings, 0x07);
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
}  // namespace proof
