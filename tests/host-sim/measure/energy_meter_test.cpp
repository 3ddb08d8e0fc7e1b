#include "host-sim/measure/energy_meter.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/host-sim/measure/synthetic_trace.hpp"

namespace sim {
namespace {

/// Tests a machine that moves along X at 50 mm/s, with the power that a test sets.
class EnergyMeterTest : public testing::Test {
 protected:
  static constexpr double kSpeed = 50.0;

  template <typename Duty>
  EnergyFigures measure(const std::string& program,
                        Duty duty_at,
                        EnergyMeter::Options options = {}) {
    const ProgrammedPath path = read_program(program, {.laser_mode = true});
    const SyntheticMachine machine{.steps_per_mm = {400, 400, 400, 400, 400, 400}};
    const double length = path.length();
    auto rows = machine.rows(
        [length](double time) { return Point{std::clamp(kSpeed * time, 0.0, length)}; },
        length / kSpeed + 1.0e-3);
    // There are rows for the beam, too: it is constant for 10 µs at a time.
    std::vector<TraceRow> all;
    std::uint64_t next = 0;
    for (const TraceRow& row : rows) {
      for (; next < row.time_ns; next += 10'000) {
        TraceRow beam = all.empty() ? TraceRow{} : all.back();
        beam.time_ns = next;
        beam.duty = duty_at(kSpeed * 1.0e-9 * static_cast<double>(next));
        all.push_back(beam);
      }
      all.push_back(row);
      all.back().duty = all.size() > 1 ? all[all.size() - 2].duty : 0.0F;
    }
    all.push_back(all.back());
    all.back().time_ns += 25'000;  // Adds the time of half a step.
    all.back().duty = 0.0F;
    PathDeviation deviation{path, machine.steps_per_mm};
    EnergyMeter meter{path, deviation, machine.steps_per_mm, std::move(options)};
    for (const TraceRow& row : all) {
      deviation.on_row(row);
      meter.on_row(row);
    }
    meter.on_end(all.back().time_ns);
    return meter.figures();
  }
};

TEST_F(EnergyMeterTest, IsOneWhereTheBeamDoesAsProgrammed) {
  const auto figures = measure("M4 S500 F3000\nG1 X10\n", [](double) { return 0.5F; });
  EXPECT_GT(figures.windows, 700U);
  EXPECT_NEAR(figures.least, 1.0, 0.015);
  EXPECT_NEAR(figures.mean, 1.0, 0.015);
  EXPECT_NEAR(figures.greatest, 1.0, 0.015);
}

TEST_F(EnergyMeterTest, SeesABurnOfATwentiethOfAMillimetre) {
  const auto figures = measure("M4 S500 F3000\nG1 X10\n",
                               [](double x) { return x > 4.0 && x < 4.05 ? 0.55F : 0.5F; });
  EXPECT_NEAR(figures.least, 1.0, 0.015);
  EXPECT_NEAR(figures.greatest, 1.1, 0.015);
  EXPECT_NEAR(figures.greatest_at_mm, 4.05, 0.02);
}

TEST_F(EnergyMeterTest, MeasuresEachRunFromItsStartToItsEnd) {
  const std::string program = "M4 S500 F3000\nG1 X2\nS0\nX4\nS1000\nX6\nG0 X8\n";
  const auto asked = [](double x) {
    return x < 2.0 ? 0.5F : x < 4.0 ? 0.0F : x < 6.0 ? 1.0F : 0.0F;
  };
  const auto figures = measure(program, asked);
  EXPECT_NEAR(figures.least, 1.0, 0.02);
  EXPECT_NEAR(figures.greatest, 1.0, 0.02);
  const auto late = measure(program, [&](double x) { return asked(x - 0.02); });
  EXPECT_NEAR(late.least, 0.61, 0.03) << "0.03 of the first 0.05 mm";
}

TEST_F(EnergyMeterTest, AsksForTheLightOfADuty) {
  const auto figures = measure("M4 S500 F3000\nG1 X10\n",
                               [](double) { return 0.8F; },
                               {.light = [](float duty) { return duty > 0.7F ? 0.5 : 0.0; }});
  EXPECT_NEAR(figures.mean, 1.0, 0.015);
}

TEST_F(EnergyMeterTest, MeasuresNothingInTheDark) {
  EXPECT_EQ(measure("F3000\nG1 X10\n", [](double) { return 0.0F; }).windows, 0U);
}

}  // namespace
}  // namespace sim
