#pragma once

#include "planner/base/coordinate.hpp"
#include "planner/geometry/arc_elements.hpp"

namespace cnc {

/// A box with its sides along the axes.
struct Box {
  Position least{};
  Position most{};
};

/// The smallest box around an arc or helix: its ends, and the outermost points
/// of its circle that it passes.
///
/// The circle is the larger of the two that rounded ends may give, so the box
/// is too small by float rounding of the radius only: less than R · 1e-6.
[[nodiscard]] Box reach_of(const CentreArc& arc);

}  // namespace cnc
