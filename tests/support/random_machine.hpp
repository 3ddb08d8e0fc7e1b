#pragma once

#include "firmware/steps/step_drive.hpp"
#include "planner/motion/block/limits.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

/// Those settings of a controller that affect motion.
struct TestMachine {
  cnc::motion::Limits limits{};
  cnc::StepTiming timing{};
};

struct MachineRanges {
  double min_steps_per_mm = 10.0;
  double max_steps_per_mm = 1600.0;
  double min_rate_mm_s = 1.0 / 60.0;
  double max_rate_mm_s = 1000.0;
  double min_acceleration = 1.0;
  double max_acceleration = 20'000.0;
};

/// Returns a machine in which every axis has its own resolution, rate and acceleration. Step rates
/// follow from the pulse as in firmware/machine/configuration.cpp.
[[nodiscard]] TestMachine random_machine(Random& random, const MachineRanges& ranges = {});

/// Returns a machine with the settings ($101, $111 …) of a small laser, the same for all axes.
[[nodiscard]] TestMachine plain_machine();

}  // namespace proof
