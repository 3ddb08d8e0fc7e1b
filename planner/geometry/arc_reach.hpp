#pragma once

#include "planner/base/coordinate.hpp"
#include "planner/geometry/arc_elements.hpp"

namespace cnc {

/// A box with its sides along the axes.
struct Box {
  Position least{};
  Position most{};
};

/// Returns the smallest box around an arc or helix. It contains both ends, and the outermost points
/// of the circle that the arc passes.
///
/// If rounding put the two ends on different circles, the larger circle is used. So the box can
/// only be too small by the float rounding of the radius, which is less than R · 1e-6.
[[nodiscard]] Box reach_of(const CentreArc& arc);

}  // namespace cnc
