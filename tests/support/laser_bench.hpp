#pragma once

#include <array>
#include <cstdint>

#include "tests/support/machine_bench.hpp"

namespace proof {

/// A homed laser with soft limits, which counts motor positions outside of the travel.
class LaserBench : public MachineBench, private sim::TraceSink {
 public:
  static constexpr std::array<double, 3> kTravel{60.0, 40.0, 20.0};
  static constexpr std::array<double, 3> kSwitch{12.0, 7.0, 3.0};
  static constexpr double kStepsPerMm = 250.0;

  LaserBench() : MachineBench{model()} {
    set({{22, 1}, {24, 120}, {25, 6000}, {26, 5}, {27, 2}, {32, 1}, {20, 1}});
    for (int axis = 0; axis < 3; ++axis)
      set({{130 + axis, kTravel[static_cast<std::size_t>(axis)]}});
    home();
    controller.add_sink(*this);
  }

  /// Number of trace rows since the start with a motor outside of the travel.
  std::size_t rows_outside = 0;

 private:
  static sim::MachineModel model() {
    sim::MachineModel model;
    for (std::size_t axis = 0; axis < 3; ++axis) model.switch_mm[axis] = kSwitch[axis];
    return model;
  }

  void on_row(const sim::TraceRow& row) override {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double mm = static_cast<double>(row.position[axis]) / kStepsPerMm - kSwitch[axis];
      const double slack = 1.01 / kStepsPerMm;
      if (mm > slack || mm < -kTravel[axis] - slack) ++rows_outside;
    }
  }
};

}  // namespace proof
