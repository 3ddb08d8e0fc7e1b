#include "planner/motion/lookahead/arc_shape.hpp"

namespace cnc::motion {

Place ArcShape::place_at(float distance) const {
  if (!turns()) return {};
  return sin_cos(angle_at(distance));
}

}  // namespace cnc::motion
