#pragma once

#include "tests/simulation/plan_check.hpp"

namespace proof {

/// Returns the greatest jerk of an axis in a motion, as a ratio to its limit.
///
/// The acceleration of a motion is known as its mean over each cell of time. Between the middles of
/// two cells it counts as a line. The slope of this line is a mean of the jerk, and never exceeds
/// the greatest jerk. In every slice, the jerk of the curve is added: 3 t′ v a + t″ v³ with the
/// derivatives of the tangent by length. On an arc these are −κ² v³ along the tangent and 3 κ v a
/// across it. Changes of curvature at joints do not count.
///
/// Successive cells with equal acceleration are divided by the duration of the first cell after
/// rest, which is a complete cell. As one cell they would move the end of a braking onto an arc
/// that is driven at constant speed much later.
[[nodiscard]] Greatest greatest_jerk(const RecordedPlan& plan, const TestMachine& machine);

}  // namespace proof
