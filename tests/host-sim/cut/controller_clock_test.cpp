#include "host-sim/cut/controller_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "planner/gcode/interpreter.hpp"
#include "planner/gcode/program_writer.hpp"
#include "planner/pipeline/action_elements.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

OrderWish random_machine(proof::Random& random) {
  const double rate = random.magnitude(20.0, 300.0);
  const double acceleration = random.magnitude(200.0, 5'000.0);
  const double jerk = random.chance(0.5) ? 0.0 : random.magnitude(1.0e3, 1.0e6);
  return {.limits = {{rate, rate}, {acceleration, acceleration}, {jerk, jerk}}};
}

TEST(ControllerClock, ARapidTakesWhatTheFormulaOfTheSearchSays) {
  constexpr double kCyclesS = 0.007;
  for (const std::uint64_t seed : proof::Trials{500}) {
    proof::Random random{seed};
    const OrderWish machine = random_machine(random);
    const Place to{random.signed_magnitude(1.0, 500.0), random.signed_magnitude(1.0, 500.0)};
    ControllerClock clock{machine};
    clock.move({machine.from, to}, 0.0, false);
    const std::vector<double> times = clock.finish();
    ASSERT_EQ(times.size(), 1U);
    const double formula = cnc::order::RapidTime{machine.limits}(to.x(), to.y());
    EXPECT_GT(times[0], 0.995 * formula);
    EXPECT_LT(times[0], 1.005 * formula + kCyclesS);
  }
}

TEST(ControllerClock, GivesATimeToEachMotionInTheOrderOfTheProgram) {
  ControllerClock clock{{}};
  clock.move({{0.0, 0.0}, {30.0, 0.0}}, 0.0, false);
  clock.move({{30.0, 0.0}, {30.0, 0.0}}, 10.0, true);
  clock.move({{30.0, 0.0}, {30.0, 20.0}}, 10.0, true);
  clock.rest();
  clock.move({{30.0, 20.0}, {30.0, 40.0}}, 5.0, true);
  const std::vector<double> times = clock.finish();
  ASSERT_EQ(times.size(), 4U);
  EXPECT_NEAR(times[0], 0.7, 0.01);
  EXPECT_EQ(times[1], 0.0);
  EXPECT_NEAR(times[2], 2.02, 0.01);
  EXPECT_NEAR(times[3], 4.01, 0.01);
  EXPECT_TRUE(clock.finish().empty());
}

/// Returns a row of lines and arcs of any size, some hardly longer than the last digit of a
/// coordinate.
std::vector<Stroke> random_row(proof::Random& random) {
  std::vector<Stroke> row;
  Place here{random.between(-100.0, 100.0), random.between(-100.0, 100.0)};
  for (int i = 0; i < 20; ++i) {
    const Place to{here.x() + random.signed_magnitude(1.0e-4, 50.0),
                   here.y() + random.signed_magnitude(1.0e-4, 50.0)};
    const double bulge = random.chance(0.3) ? 0.0 : random.signed_magnitude(0.01, 8.0);
    row.push_back({here, to, bulge});
    here = to;
  }
  return row;
}

TEST(WrittenPath, IsThePathThatAReaderOfTheProgramDrives) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    const cnc::gcode::PrintGrid grid{static_cast<std::uint8_t>(3 + random.below(3))};
    const std::vector<Stroke> row = random_row(random);
    cnc::gcode::ProgramWriter writer{grid};
    writer.set_feed(1'000'000);
    cnc::gcode::Interpreter reader;
    const auto begin = writer.rapid(row.front().from);
    ASSERT_TRUE(begin.ok());
    std::string text{begin.value()};
    WrittenPath path{grid, row.front().from};
    for (const Stroke& stroke : row) {
      const auto written = writer.cut(stroke.from, stroke.to, stroke.bulge);
      ASSERT_TRUE(written.ok());
      text += written.value();
      std::vector<cnc::PathElement> read;
      while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const cnc::Position from = reader.position();
        const auto actions = reader.interpret(std::string_view{text}.substr(0, end));
        ASSERT_TRUE(actions.ok());
        for (const cnc::gcode::Action& action : actions.value()) {
          if (!cnc::ActionElements::accepts(action)) continue;
          cnc::ActionElements elements;
          elements.begin(action, from, 0.01F);
          while (!elements.done()) read.push_back(elements.next().element);
        }
        text.erase(0, end + 1);
      }
      if (&stroke == &row.front()) read.erase(read.begin());  // Removes the rapid to the start.
      const std::vector<cnc::PathElement>& driven = path.next(stroke);
      ASSERT_EQ(driven.size(), read.size());
      for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(driven[i].start, read[i].start);
        EXPECT_EQ(driven[i].end, read[i].end);
        EXPECT_EQ(driven[i].bulge, read[i].bulge);
      }
    }
  }
}

}  // namespace
}  // namespace sim::cut
