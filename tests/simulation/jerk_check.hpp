#pragma once

#include "tests/simulation/plan_check.hpp"

namespace proof {

/// The greatest jerk of an axis in a motion, as a ratio of its limit.
///
/// The acceleration of a motion is known as the mean over each cell of time, in
/// which it is constant; from the middle of one cell to that of the next its
/// change over the time is a mean of the jerk, never above its greatest. Added
/// to it is what the curve asks for: 3 t′ v a + t″ v³ with the derivatives of its tangent
/// by length, which on an arc are −κ² v³ along and 3 κ v a across the tangent.
/// At joints the change of curvature is not counted.
[[nodiscard]] Greatest greatest_jerk(const RecordedPlan& plan, const TestMachine& machine);

}  // namespace proof
