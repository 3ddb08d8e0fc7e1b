#include "planner/motion/block/path_units.hpp"

namespace cnc::motion {

PathUnits to_units(float mm) {
  // A float from kLong on has no binary digits below 2^-20, so the conversion in the last line is
  // exact.
  constexpr float kLong = 2048.0F;
  if (mm < kLong) return truncated(mm * kUnitsPerMm);
  return truncated(mm * 1'048'576.0F) * 65'536;
}

}  // namespace cnc::motion
