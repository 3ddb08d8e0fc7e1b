#include "planner/motion/block/path_units.hpp"

namespace cnc::motion {

PathUnits to_units(float mm) {
  // A float of this size has no digits below 2^-20, so the second conversion is exact.
  constexpr float kLong = 2048.0F;
  if (mm < kLong) return truncated(mm * kUnitsPerMm);
  return truncated(mm * 1'048'576.0F) * 65'536;
}

}  // namespace cnc::motion
