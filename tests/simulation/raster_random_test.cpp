#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "host-sim/machine/simulator.hpp"
#include "host-sim/measure/driven_path.hpp"
#include "host-sim/measure/path_deviation.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "tests/support/laser_settings.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

constexpr double kPictureStepsPerMm = 250.0;

/// Checks that the output always belongs to the position in the program, to a step. It is for M3,
/// whose power does not depend on the speed. The beam must be off while the machine is at rest.
class PowerJudge final : public sim::TraceSink {
 public:
  PowerJudge(const sim::ProgrammedPath& path, const sim::PathDeviation& deviation)
      : path_{path}, deviation_{deviation} {}

  void on_row(const sim::TraceRow& row) override {
    const bool steps = row.position != last_.position;
    if (steps && unexplained_ && row.duty == 0.0F) ++wrong;
    const std::size_t piece = deviation_.present_match().piece;
    const double way = deviation_.present_match().nearest.fraction;
    const bool fits = demanded(piece, way, row.duty);
    if (row.duty > 0.0F && !fits) ++wrong;
    if (row.duty > 0.0F) ++lit;
    unexplained_ = row.duty == 0.0F && !fits;
    last_ = row;
  }

  std::size_t lit = 0;
  std::size_t wrong = 0;

 private:
  /// Two steps in either direction are allowed, because the follower may trail by one step.
  [[nodiscard]] bool demanded(std::size_t piece, double fraction, float duty) const {
    constexpr double kReach = 2.5 / kPictureStepsPerMm;
    if (is(piece, duty)) return true;
    double way = fraction * path_.pieces[piece].curve.length();
    for (std::size_t i = piece; i > 0 && way <= kReach; way += path_.pieces[i].curve.length()) {
      if (is(--i, duty)) return true;
    }
    way = (1.0 - fraction) * path_.pieces[piece].curve.length();
    for (std::size_t i = piece; i + 1 < path_.pieces.size() && way <= kReach;) {
      if (is(++i, duty)) return true;
      way += path_.pieces[i].curve.length();
    }
    return false;
  }
  [[nodiscard]] bool is(std::size_t piece, float duty) const {
    return std::abs(path_.pieces[piece].spindle_speed / 1000.0 - static_cast<double>(duty)) <
           2.0e-5;
  }

  const sim::ProgrammedPath& path_;
  const sim::PathDeviation& deviation_;
  sim::TraceRow last_{};
  bool unexplained_ = false;
};

/// Returns rows in any direction, on three decimals or six, each turned by less than 130° against
/// the last one.
std::string random_picture(Random& random) {
  std::string text = "G21 G90 M3 F6000 S0\n";
  double x = 0.0;
  double y = 0.0;
  double angle = random.chance(0.5) ? 0.0 : random.between(0.0, 6.28);
  const bool coarse = random.chance(0.5);
  for (int row = 0; row < 5; ++row) {
    const double step = random.magnitude(0.03, 0.3);
    const std::size_t pixels = 1 + random.below(200);
    if (random.chance(0.5)) text += fmt::format("F{:.0f}\n", random.magnitude(600.0, 20'000.0));
    std::size_t power = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
      const double length = random.chance(0.1) ? random.magnitude(0.02, 4.0) : step;
      x += length * std::cos(angle);
      y += length * std::sin(angle);
      if (!random.chance(0.3)) power = random.below(1001);
      text += coarse ? fmt::format("G1 X{:.3f} Y{:.3f} S{}\n", x, y, power)
                     : fmt::format("G1 X{:.6f} Y{:.6f} S{}\n", x, y, power);
    }
    angle += random.signed_magnitude(0.3, 2.2);
  }
  return text;
}

/// Holds, resumes and changes the feed at random times.
void meddle_with(cnc::Machine& machine, Random& random) {
  if (random.chance(0.01)) machine.feed_hold();
  if (random.chance(0.02)) machine.resume();
  if (!random.chance(0.005)) return;
  cnc::OverridePercent percent = machine.overrides();
  percent.feed = random.chance(0.5) ? 150 : 40;
  machine.set_overrides(percent);
}

// Compares with the program as an independent reader reads it, line by line.
TEST(RandomRaster, HasThePowerOfTheProgramAtEachPlace) {
  const Trials trials{200};
  std::size_t lit = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const std::string text = random_picture(random);
    sim::Simulator simulator{text, {}};
    set_up_laser(simulator, kPictureStepsPerMm, 400.0, random.magnitude(500.0, 5000.0));
    EXPECT_EQ(simulator.change_setting(0, 1.0F), "");
    EXPECT_EQ(simulator.change_setting(cnc::setting::kJunctionDeviation, 0.002F), "");
    const bool limits_jerk = random.chance(0.3);
    for (std::uint16_t axis = 0; axis < 2 && limits_jerk; ++axis) {
      const auto number = static_cast<std::uint16_t>(cnc::setting::kJerk + axis);
      EXPECT_EQ(simulator.change_setting(number, 100'000.0F), "");
    }
    const auto path = sim::read_program(text, sim::read_options_for(simulator.settings()));
    if (path.pieces.empty()) continue;
    const cnc::AxisArray<double> scales{250.0, 250.0, 250.0, 250.0, 250.0, 250.0};
    sim::PathDeviation deviation{path, scales};
    PowerJudge judge{path, deviation};
    deviation.on_row({});
    simulator.add_sink(deviation);
    simulator.add_sink(judge);
    int turns = 0;
    for (; turns < kMaxTurns && !simulator.done(); ++turns) {
      meddle_with(simulator.machine(), random);
      simulator.turn();
    }
    ASSERT_TRUE(simulator.done());
    EXPECT_EQ(simulator.result().alarm, 0);
    EXPECT_EQ(judge.wrong, 0U);
    EXPECT_LE(deviation.greatest_axis_excess().value, 0.002 + 0.0016);
    lit += judge.lit;
  }
  std::printf("rasters at random: %zu rows of the trace with a lit beam\n", lit);
}

}  // namespace
}  // namespace proof
