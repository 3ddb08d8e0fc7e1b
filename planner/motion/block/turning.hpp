#pragma once

#include <algorithm>

namespace cnc::motion {

/// Division of an acceleration limit A on a curve between turning and the change of speed. A is
/// assumed to be the same in all directions. Let κ be the curvature, v the speed, and a the
/// acceleration along the path. With α = a / A, the limits are
///   α² + (v² κ / A)² ≤ 1
/// and, where a time window T limits jerk to A / T,
///   (α / T + v³ κ² / A)² + (3 κ v α)² ≤ 1 / T²,
/// because jerk is ȧ − κ² v³ along the tangent and 3 κ v a across it. The members are ratios to A,
/// so that curves with different limits can be combined; see both().
struct Turning {
  float curvature = 0.0F;    ///< Curvature κ ≥ 0, 1/mm; 0 for a line.
  float speed_ratio = 0.0F;  ///< κ / A, s²/mm².
  float jerk_ratio = 0.0F;   ///< κ² / A, s²/mm³.

  [[nodiscard]] static Turning of(float curvature, float acceleration);

  /// Returns the v² at which turning at constant speed requires all of A, or the v² at which it
  /// requires 95 % of the jerk limit, whichever is lower. The other 5 % of the jerk limit are left
  /// for speeding up to that v².
  /// @param window_s T in s. Without a window it is 0: then each axis has its own limit, which is
  /// not known here, and the function returns 1e12, which is no limit.
  [[nodiscard]] float speed_limit_square(float window_s) const;

  /// Returns the greatest a that may hold over `distance` mm, from a point where v² is
  /// `speed_square`. v² is assumed to grow over the whole distance, but at most to `cap_square`.
  /// @param acceleration A along the path
  /// @param lag_s time for which v is assumed to continue growing by a after `distance`; see
  /// lag_of()
  /// @pre window_s > 0
  [[nodiscard]] float steepest(float acceleration,
                               float distance,
                               float speed_square,
                               float cap_square,
                               float window_s,
                               float lag_s = 0.0F) const;

  /// Returns the greatest a that the jerk limit allows at a v² of `speed_square`.
  /// @param acceleration A along the path
  /// @pre window_s > 0
  [[nodiscard]] float within_jerk(float acceleration, float speed_square, float window_s) const;

  constexpr bool operator==(const Turning&) const = default;

 private:
  [[nodiscard]] float within_acceleration(float acceleration,
                                          float distance,
                                          float speed_square) const;
};

/// Returns the time, in s, for which Turning::steepest() assumes that the speed continues to grow
/// by the acceleration a after `distance`. The time is at most 0.35 of the time window T. It is
/// shorter on a path that turns more.
///
/// The motion is the mean of the plan over the window. Where the plan begins to speed up by a, the
/// motion has the jerk a / T at first. When the window has passed, its jerk is −a / T. By then the
/// plan may have sped up further, so the motion is faster by up to a T / 2. Where the plan slows
/// down, the motion was faster before, by the same amount. But the faster the motion is, the less
/// acceleration turning leaves for the plan. This effect grows with k = κ A T². With the time 0.28
/// k^−¼ T, no simulated motion, over all k, exceeds the limits of Turning.
[[nodiscard]] float lag_of(float curvature, float acceleration, float window_s);

/// Returns an a ≤ `most` for which a ≤ within(a). The result is at most the greatest a with this
/// property, and at most a fifth below it.
/// @param within returns the acceleration that is left at the speed to which a leads; the result
/// must not rise with a
template <typename Within>
[[nodiscard]] float steepest_within(float most, Within&& within) {
  float high = most;
  float low = within(high);
  constexpr int kHalvings = 4;
  for (int i = 0; i < kHalvings && low < high; ++i) {
    high = std::min(high, within(low));
    const float middle = 0.5F * (low + high);
    const float there = within(middle);
    if (there < middle) {
      high = middle;
      low = std::max(low, there);
    } else {
      low = middle;
      high = std::min(high, there);
    }
  }
  return std::min(low, high);
}

/// Returns a Turning that keeps the limits of both `a` and `b`.
[[nodiscard]] inline Turning both(const Turning& a, const Turning& b) {
  return {std::max(a.curvature, b.curvature),
          std::max(a.speed_ratio, b.speed_ratio),
          std::max(a.jerk_ratio, b.jerk_ratio)};
}

}  // namespace cnc::motion
