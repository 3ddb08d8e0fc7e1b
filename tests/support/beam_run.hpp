#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "host-sim/machine/simulator.hpp"
#include "host-sim/measure/driven_path.hpp"
#include "host-sim/measure/energy_meter.hpp"
#include "tests/support/laser_settings.hpp"

namespace proof {

/// A run of a laser machine: measures the energy of a program's beam pulses.
struct BeamRun {
  double steps_per_mm = 400.0;
  double speed = 200.0;         ///< Greatest speed of the axes, mm/s.
  double acceleration = 500.0;  ///< Acceleration of the axes, mm/s².
  std::vector<std::pair<int, double>> settings{};
  sim::EnergyMeter::Options options{};

  [[nodiscard]] sim::EnergyFigures measure(const std::string& program) const {
    sim::Simulator simulator{program, {}};
    set_up_laser(simulator, steps_per_mm, speed, acceleration);
    // A step pulse of 1 µs makes the shortest slot, so that steps of other axes come at most 2 µs
    // early.
    EXPECT_EQ(simulator.change_setting(0, 1.0F), "");
    for (const auto& [number, value] : settings) {
      EXPECT_EQ(
          simulator.change_setting(static_cast<std::uint16_t>(number), static_cast<float>(value)),
          "");
    }
    // Energy is counted per millimetre of the driven path, which is a little shorter than the
    // programmed one at blended corners.
    const sim::ProgrammedPath path =
        sim::driven_path(sim::read_program(program, sim::read_options_for(simulator.settings())),
                         cnc::limits_from(simulator.settings()));
    const cnc::AxisArray<double> scales{
        steps_per_mm, steps_per_mm, steps_per_mm, 250.0, 250.0, 250.0};
    sim::PathDeviation deviation{path, scales};
    sim::EnergyMeter meter{path, deviation, scales, options};
    simulator.add_sink(deviation);
    simulator.add_sink(meter);
    EXPECT_TRUE(simulator.run().refusals.empty()) << program;
    return meter.figures();
  }
};

}  // namespace proof
