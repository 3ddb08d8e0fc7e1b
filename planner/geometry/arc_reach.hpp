#pragma once

#include "planner/base/coordinate.hpp"
#include "planner/geometry/arc_elements.hpp"

namespace cnc {

/// A box with its sides along the axes.
struct Box {
  Position least{};
  Position most{};
};

/// Returns the smallest box around an arc or helix: it holds both ends, and the outermost points of
/// the circle that the arc passes.
///
/// Rounded ends may give two circles; the larger one is used. So the box is too small by float
/// rounding of the radius only, which is less than R · 1e-6.
[[nodiscard]] Box reach_of(const CentreArc& arc);

}  // namespace cnc
