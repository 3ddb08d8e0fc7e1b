#include "tests/support/random_machine.hpp"

#include <algorithm>

namespace proof {
namespace {

void set_pulse(TestMachine& machine, std::uint32_t pulse) {
  machine.timing.pulse = pulse;
  const auto slot = static_cast<float>(2 * pulse);
  machine.limits.steps_per_s_one_motor =
      0.9F * static_cast<float>(cnc::motion::kTicksPerSecond) / slot;
  machine.limits.steps_per_s_all_motors = 200'000.0F;
}

}  // namespace

TestMachine random_machine(Random& random, const MachineRanges& ranges) {
  TestMachine machine;
  // Most machines get a usual speed.
  const double usual_rate = std::max(ranges.min_rate_mm_s, 0.01 * ranges.max_rate_mm_s);
  const double base_rate = random.magnitude(random.chance(0.8) ? usual_rate : ranges.min_rate_mm_s,
                                            ranges.max_rate_mm_s);
  const double base = random.magnitude(ranges.min_acceleration, ranges.max_acceleration);
  const double spread = random.chance(0.3) ? 1.0 : random.magnitude(1.0, 30.0);
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    machine.limits.scale[axis] = cnc::AxisScale{
        static_cast<float>(random.magnitude(ranges.min_steps_per_mm, ranges.max_steps_per_mm))};
    machine.limits.rate_mm_s[axis] =
        static_cast<float>(base_rate / random.magnitude(1.0, spread + 1e-9));
    machine.limits.acceleration_mm_s2[axis] =
        static_cast<float>(base / random.magnitude(1.0, spread + 1e-9));
  }
  machine.limits.junction_deviation_mm =
      random.chance(0.15) ? 0.0F : static_cast<float>(random.magnitude(1e-4, 1.0));
  // 1…12 µs of pulse, 0.25…12 µs of set-up; most machines get at most 5 µs.
  const double longest_us = random.chance(0.25) ? 12.0 : 5.0;
  set_pulse(machine, static_cast<std::uint32_t>(4.0 * random.magnitude(1.0, longest_us)));
  machine.timing.direction_set_up =
      static_cast<std::uint32_t>(4.0 * random.magnitude(0.25, longest_us));
  return machine;
}

TestMachine plain_machine() {
  TestMachine machine;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    machine.limits.scale[axis] = cnc::AxisScale{160.0F};
    machine.limits.rate_mm_s[axis] = 200.0F;
    machine.limits.acceleration_mm_s2[axis] = 1500.0F;
  }
  set_pulse(machine, 20);
  return machine;
}

}  // namespace proof
