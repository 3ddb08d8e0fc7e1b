#include "tests/support/product_limits.hpp"

#include <algorithm>

namespace proof {

sim::MotionLimits limits_of(const cnc::motion::Limits& product) {
  sim::MotionLimits limits;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const auto scale = static_cast<double>(product.scale[axis].steps_per_mm());
    limits.steps_per_mm[axis] = scale;
    limits.rate[axis] = std::min(static_cast<double>(product.rate_mm_s[axis]),
                                 static_cast<double>(product.steps_per_s_one_motor) / scale);
    limits.acceleration[axis] = static_cast<double>(product.acceleration_mm_s2[axis]);
  }
  limits.step_rate = static_cast<double>(product.steps_per_s_all_motors);
  return limits;
}

}  // namespace proof
