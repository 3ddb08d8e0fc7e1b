#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "host-sim/machine/simulator.hpp"

namespace proof {

/// Ten minutes of machine time, in cycles; a job that takes longer hangs.
inline constexpr int kMaxTurns = 600'000;

/// Sets up a laser with the same limits on X, Y and Z, in mm/s and mm/s².
inline void set_up_laser(sim::Simulator& simulator,
                         double steps_per_mm,
                         double speed,
                         double acceleration) {
  const auto change = [&simulator](std::size_t number, double value) {
    const auto stored =
        simulator.change_setting(static_cast<std::uint16_t>(number), static_cast<float>(value));
    EXPECT_EQ(stored, "") << "$" << number << "=" << value;
  };
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    change(cnc::setting::kStepsPerMm + axis, steps_per_mm);
    change(cnc::setting::kRate + axis, 60.0 * speed);
    change(cnc::setting::kAcceleration + axis, acceleration);
  }
  change(cnc::setting::kLaserMode, 1.0);
}

}  // namespace proof
