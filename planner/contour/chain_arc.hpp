#pragma once

#include "planner/geometry/vector.hpp"

namespace cnc {

/// An arc of at most half a turn in double precision, or a line where the bulge is 0 (see Arc).
struct ChainArc {
  Vec2D start{0.0, 0.0};  ///< mm.
  Vec2D end{0.0, 0.0};
  double bulge = 0.0;
};

}  // namespace cnc
