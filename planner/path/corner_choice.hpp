#pragma once

#include "planner/motion/block/limits.hpp"
#include "planner/path/corner.hpp"

namespace cnc::path {

/// A rounded corner that is compared with a stop.
struct RoundedCorner {
  float trim_mm = 0.0F;  ///< Length that the blend takes from each side.
  /// Length of the shorter side that the corner may use, including the trim.
  float shorter_mm = 0.0F;
  float feed_mm_s = 0.0F;  ///< Greater one of the feeds of both sides; 0 or less for a rapid.
};

/// Returns whether a stop at the corner takes less time than its blend.
///
/// The blend of a sharp turn is so small that it is driven very slowly. Braking to a stop and
/// speeding up again may take less time. Let v be the speed on the blend, L its length, t the trim
/// and A the acceleration. Let V be the speed that is reached next to the blend. The blend takes
/// longer than the stop by
///   L / v − 2 v / A − (2 t − v² / A) / V,
/// where (2 t − v² / A) / V counts only if it is positive. If V is great, the difference is
/// positive for turns of 115° or more.
///
/// Where jerk is limited, v is smaller. Also, a chain of moves with blends has a single window of
/// time, while each move between stops has its own suitable window (WindowChoice). So with jerk,
/// the comparison counts only a share of 2 v / A. This share was fitted to simulated zig-zags: no
/// choice costs them more than some hundredths of the time.
[[nodiscard]] bool is_stop_sooner(const Corner& corner,
                                  const RoundedCorner& rounded,
                                  const motion::Limits& limits);

}  // namespace cnc::path
