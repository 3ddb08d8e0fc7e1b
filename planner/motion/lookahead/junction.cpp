#include "planner/motion/lookahead/junction.hpp"

#include "planner/base/scalar_math.hpp"

namespace cnc::motion {

float turn_square(const AxisArray<float>& before, const AxisArray<float>& after) {
  float sum = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) sum += square(after[axis] - before[axis]);
  return sum;
}

bool is_tangent(const AxisArray<float>& before, const AxisArray<float>& after) {
  return turn_square(before, after) <= square(kTangentTurn);
}

}  // namespace cnc::motion
