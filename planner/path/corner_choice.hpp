#pragma once

#include "planner/motion/block/limits.hpp"
#include "planner/path/corner.hpp"

namespace cnc::path {

/// What is to be compared with a stop at a corner.
struct RoundedCorner {
  float trim_mm = 0.0F;     ///< How much the blend takes of each side.
  float shorter_mm = 0.0F;  ///< What the corner has of the shorter side, trim included.
  float feed_mm_s = 0.0F;   ///< The greater of both sides; 0 or less for a rapid.
};

/// Returns whether a stop at the corner takes less time than its blend.
///
/// A blend of a sharp turn is so small that it is crept along: braking to a stop and starting from
/// it is over sooner. With the speed v on the blend, which is L long, trim t, acceleration A and
/// the speed V that is reached beside it, the blend takes longer by
///   L / v − 2 v / A − (2 t − v² / A) / V,
/// without the last part where that is negative: from a turn of 115° on if V is great. Where jerk
/// is limited, v is less, and the whole chain of moves that a blend makes has one window of time,
/// while moves between stops have each the one that suits it (WindowChoice): stops are sooner from
/// a share of the blend's time on, which was fitted to simulated zig-zags, so that no choice there
/// costs more than some hundredths.
[[nodiscard]] bool is_stop_sooner(const Corner& corner,
                                  const RoundedCorner& rounded,
                                  const motion::Limits& limits);

}  // namespace cnc::path
