#pragma once

#include <algorithm>

namespace cnc::motion {

/// How a curve divides an acceleration limit A, taken as the same in all
/// directions, between turning and changing speed. With curvature κ, speed v and
/// path acceleration a = α A:
///   α² + (v² κ / A)² ≤ 1
/// and, where jerk is limited to A / T,
///   (α / T + v³ κ² / A)² + (3 κ v α)² ≤ 1 / T²,
/// for along the tangent jerk is ȧ − κ² v³, and across it 3 κ v a. In ratios to A,
/// so that curves with limits of their own can be taken together.
struct Turning {
  float curvature = 0.0F;    ///< κ ≥ 0, 1/mm; 0 does not turn.
  float speed_ratio = 0.0F;  ///< κ / A.
  float jerk_ratio = 0.0F;   ///< κ² / A.

  [[nodiscard]] static Turning of(float curvature, float acceleration);

  /// v² at which, on a level course, all of A is for turning, or nineteen twentieths of
  /// the jerk: the rest is for the way there. @param window_s T; without one, 0, each axis
  /// has a limit of its own, which is not known here, and this is none.
  [[nodiscard]] float speed_limit_square(float window_s) const;

  /// The greatest a that may hold over `distance` mm from where v² is
  /// `speed_square`, v² growing all the way up to at most `cap_square`.
  /// @param acceleration A along the path.
  /// @pre window_s > 0
  /// @param lag_s for how long v may go on growing by a until the motion takes a back.
  [[nodiscard]] float steepest(float acceleration,
                               float distance,
                               float speed_square,
                               float cap_square,
                               float window_s,
                               float lag_s = 0.0F) const;

  /// As far as jerk goes, at this v². @pre window_s > 0
  [[nodiscard]] float within_jerk(float acceleration, float speed_square, float window_s) const;

  constexpr bool operator==(const Turning&) const = default;

 private:
  [[nodiscard]] float within_acceleration(float acceleration,
                                          float distance,
                                          float speed_square) const;
};

/// s, for how long the speed is taken to go on growing by a until the motion takes a back:
/// at most 0.35 of the window, less where it turns more.
///
/// The motion is the mean: where the plan speeds up by a, the motion's jerk is a / T then, and
/// −a / T when the window has passed. By then the plan may have gone on, and the motion is
/// faster by up to a T / 2; where the plan slows down it was so before. But the faster it
/// is, the less a the plan had: the more so, the more turning leaves of a, by k = κ A T².
/// With 0.28 k^−¼ T no motion that was simulated over all k is beyond the limits of Turning.
[[nodiscard]] float lag_of(float curvature, float acceleration, float window_s);

/// The greatest a ≤ `most` that is within what is left at the speed that it leads to,
/// `within(a)`, which falls as a grows. Never more, and at most a fifth less.
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

/// What both ask for.
[[nodiscard]] inline Turning both(const Turning& a, const Turning& b) {
  return {std::max(a.curvature, b.curvature),
          std::max(a.speed_ratio, b.speed_ratio),
          std::max(a.jerk_ratio, b.jerk_ratio)};
}

}  // namespace cnc::motion
