#include "planner/path/space_biarc.hpp"

#include <cmath>

#include "planner/base/scalar_math.hpp"

namespace cnc::path {

/// Let d be the length of the tangents of both arcs: the distance from an end of the biarc to the
/// point where the two tangents of its arc intersect. The joint is the middle between those two
/// points, whose distance is 2 d: |chord − d (start + end)| = 2 d.
std::optional<AxisVector> space_joint(const AxisVector& start,
                                      const AxisVector& chord,
                                      const AxisVector& end) {
  const float along = dot(chord, start) + dot(chord, end);
  const float apart = 2.0F * (1.0F - dot(start, end));
  const float chord_square = dot(chord, chord);
  if (along <= 0.0F || chord_square <= 0.0F) return std::nullopt;
  const float d = chord_square / (along + std::sqrt(square(along) + apart * chord_square));
  const AxisVector both = sum_of(start, -1.0F, end);
  return scaled(0.5F, sum_of(chord, d, both));
}

}  // namespace cnc::path
