#pragma once

#include "planner/motion/block/limits.hpp"
#include "planner/path/corner.hpp"

namespace cnc::path {

/// A rounded corner, which is to be compared with a stop.
struct RoundedCorner {
  float trim_mm = 0.0F;     ///< Length that the blend takes of each side.
  float shorter_mm = 0.0F;  ///< Length that the corner may use of the shorter side, trim included.
  float feed_mm_s = 0.0F;   ///< The greater feed of the two sides; 0 or less for a rapid.
};

/// Returns whether a stop at the corner takes less time than its blend.
///
/// A blend of a sharp turn is so small that it is driven very slowly; braking to a stop and
/// speeding up again takes less time. Let v be the speed on the blend, L its length, t the trim, A
/// the acceleration and V the speed that is reached next to the blend. The blend takes longer than
/// the stop by
///   L / v − 2 v / A − (2 t − v² / A) / V,
/// where the last part counts only if it is positive. The difference is positive for turns from
/// 115° on if V is great. Where jerk is limited, v is smaller. Also, the whole chain of moves that
/// a blend makes has one window of time, while each move between stops has the window that suits it
/// (WindowChoice). So with jerk a stop is sooner from a share of the blend's time on. That share
/// was fitted to simulated zig-zags, so that no choice there costs more than some hundredths of the
/// time.
[[nodiscard]] bool is_stop_sooner(const Corner& corner,
                                  const RoundedCorner& rounded,
                                  const motion::Limits& limits);

}  // namespace cnc::path
