// Tests G43.4 against a model of the machine in double precision that uses other formulas.

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "firmware/machine/configuration.hpp"
#include "host-sim/machine/five_axis_model.hpp"
#include "tests/support/five_axis_places.hpp"
#include "tests/support/machine_bench.hpp"
#include "tests/support/random_five_axes.hpp"
#include "tests/support/trials.hpp"

namespace proof::five_axes {
namespace {

using cnc::kinematics::ToolCentre;
using sim::FiveAxisModel;

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

/// Records the knots that the motors pass, one for each cell of time.
class Knots final : public cnc::motion::ShapingObserver {
 public:
  void on_cell(const cnc::motion::ShapedCell& cell) override { places.push_back(cell.planned); }

  std::vector<cnc::AxisArray<cnc::StepPosition>> places;
};

constexpr double kCellS = 1.0e-3;

/// Greatest figures over all motions, as shares of their limits if these are known.
struct MotionFigures {
  double off_line_mm = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
  double feed = 0.0;
  double min_feed = 1.0;  ///< Least ratio of a motion's greatest feed to its programmed feed.
  /// Greatest distance of a motion's end from the tip's position on whole steps, mm.
  double steps_mm = 0.0;
};

/// A machine that drives successive straight motions of the tip.
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

  /// Drives to a position and measures the motion.
  void drive(const std::string& words, MotionFigures& figures) {
    knots_.places.clear();
    const Point from = point_of(machine().interpreter().position());
    const auto feed = static_cast<double>(machine().interpreter().state().feed);
    send(words);
    finish();
    const Point to = point_of(machine().interpreter().position());
    measure(from, to, feed, figures);
    // Motors stand on whole steps: half a step of 0.01 degrees makes 0.06 mm at 0.7 m.
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
      // Number of cells after which rounding hardly affects a mean.
      constexpr std::size_t kCells = 10;
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
      figures.min_feed = std::min(figures.min_feed, greatest_feed / feed);
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
    // The mean is over some cells, because single precision moves each knot by up to 0.3 µm.
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

/// Returns a line of the tip by up to some hundred millimetres, with motions of the rotary axes.
std::string random_motion(Random& random, double max_turn_deg) {
  std::string words = fmt::format("G1 X{:.3f} Y{:.3f} Z{:.3f}",
                                  random.between(-80.0, 80.0),
                                  random.between(-80.0, 80.0),
                                  random.between(-40.0, 40.0));
  return words + fmt::format(" {}{:.3f} C{:.3f}",
                             "AB"[random.below(2)],
                             random.between(-90.0, 90.0),
                             random.between(-max_turn_deg, max_turn_deg));
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
        figures.min_feed,
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
    std::printf("kind %d: feed %.4f to %.4f\n", kind, figures.min_feed, figures.feed);
    EXPECT_GT(figures.min_feed, 0.99);
    EXPECT_LT(figures.feed, 1.001);
  }
}

}  // namespace
}  // namespace proof::five_axes
