#pragma once

#include "tests/simulation/plan_check.hpp"

namespace proof {

/// The greatest jerk of an axis in a motion, as a ratio of its limit.
///
/// The acceleration of a motion is known as the mean over each cell of time, in
/// which it is constant; between the middles of two cells it is taken as a line, whose slope
/// is a mean of the jerk, never above its greatest. Added to it in every slice is what the
/// curve asks for: 3 t′ v a + t″ v³ with the derivatives of its tangent
/// by length, which on an arc are −κ² v³ along and 3 κ v a across the tangent.
/// At joints the change of curvature is not counted. Cells in a row that have the same
/// acceleration are told apart by the first after rest, which is a whole one: taken as one they
/// would put the end of a braking onto an arc that is driven level long after it.
[[nodiscard]] Greatest greatest_jerk(const RecordedPlan& plan, const TestMachine& machine);

}  // namespace proof
