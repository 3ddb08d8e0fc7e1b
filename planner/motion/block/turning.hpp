#pragma once

#include <algorithm>

namespace cnc::motion {

/// How a curve divides an acceleration limit A between turning and the change of speed. A is taken
/// to be the same in all directions. With curvature κ, speed v and path acceleration a = α A:
///   α² + (v² κ / A)² ≤ 1
/// and, where jerk is limited to A / T,
///   (α / T + v³ κ² / A)² + (3 κ v α)² ≤ 1 / T²,
/// because jerk is ȧ − κ² v³ along the tangent and 3 κ v a across it. The members are ratios to A,
/// so that curves with different limits can be combined, see both().
struct Turning {
  float curvature = 0.0F;    ///< κ ≥ 0, 1/mm; 0 for a line.
  float speed_ratio = 0.0F;  ///< κ / A.
  float jerk_ratio = 0.0F;   ///< κ² / A.

  [[nodiscard]] static Turning of(float curvature, float acceleration);

  /// Returns the v² at which turning at constant speed needs all of A, or 95 % of the jerk,
  /// whichever is lower. The rest of the jerk is for reaching that speed.
  /// @param window_s T. Without a window, at 0, each axis has its own limit, which is not known
  /// here; the function then returns 1e12, which is no limit.
  [[nodiscard]] float speed_limit_square(float window_s) const;

  /// Returns the greatest a that may hold over `distance` mm, from a point where v² is
  /// `speed_square`. v² is taken to grow over the whole distance, up to at most `cap_square`.
  /// @param acceleration A along the path
  /// @param lag_s time for which v may continue to grow by a until the motion ends its acceleration
  /// @pre window_s > 0
  [[nodiscard]] float steepest(float acceleration,
                               float distance,
                               float speed_square,
                               float cap_square,
                               float window_s,
                               float lag_s = 0.0F) const;

  /// Returns the greatest a that jerk allows at this v². @pre window_s > 0
  [[nodiscard]] float within_jerk(float acceleration, float speed_square, float window_s) const;

  constexpr bool operator==(const Turning&) const = default;

 private:
  [[nodiscard]] float within_acceleration(float acceleration,
                                          float distance,
                                          float speed_square) const;
};

/// Returns the time, in s, for which the speed is taken to continue growing by a until the motion
/// ends its acceleration. The time is at most 0.35 of the window, and shorter on a path that turns
/// more.
///
/// The motion is the mean of the plan. Where the plan speeds up by a, the motion has the jerk a / T
/// at first, and −a / T when the window has passed. By then the plan may have sped up further, and
/// the motion is faster by up to a T / 2. Where the plan slows down, the motion was faster before,
/// by as much. But the faster the motion is, the smaller was the acceleration a that turning left
/// to the plan. This effect grows with k = κ A T². With 0.28 k^−¼ T, no motion that was simulated
/// over all k exceeds the limits of Turning.
[[nodiscard]] float lag_of(float curvature, float acceleration, float window_s);

/// Returns nearly the greatest a ≤ `most` for which a ≤ within(a). The result is never greater than
/// that, and at most a fifth less.
/// @param within returns the acceleration that is left at the speed to which a leads; it falls as a
/// grows
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

/// Returns a turning that keeps the limits of both `a` and `b`.
[[nodiscard]] inline Turning both(const Turning& a, const Turning& b) {
  return {std::max(a.curvature, b.curvature),
          std::max(a.speed_ratio, b.speed_ratio),
          std::max(a.jerk_ratio, b.jerk_ratio)};
}

}  // namespace cnc::motion
