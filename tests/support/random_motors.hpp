#pragma once

#include "planner/motion/motors/motor_stage.hpp"
#include "tests/support/random_source.hpp"

namespace proof {

/// Returns a random shaper, or none.
inline cnc::motion::ShaperSetting random_shaper(Random& random) {
  cnc::motion::ShaperSetting shaper;
  shaper.kind = static_cast<cnc::motion::ShaperKind>(random.below(5));
  shaper.frequency_hz = static_cast<float>(random.magnitude(10.0, 200.0));
  shaper.damping = random.chance(0.3) ? 0.0F : static_cast<float>(random.between(0.0, 0.5));
  return shaper;
}

inline cnc::AxisArray<cnc::motion::ShaperSetting> random_shapers(Random& random) {
  cnc::AxisArray<cnc::motion::ShaperSetting> shapers{};
  for (auto& shaper : shapers) shaper = random_shaper(random);
  return shapers;
}

}  // namespace proof
