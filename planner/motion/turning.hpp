#pragma once

namespace cnc::motion {

/// Limits along a curve taken as the same in all directions: for a curvature κ,
/// a path acceleration a and a speed v,
///   a² + (κ v²)² ≤ A²  and, if jerk is limited,  (a / T + κ² v³)² + (3 κ v a)² ≤ (A / T)²,
/// for along the tangent jerk is ȧ − κ² v³, and across it 3 κ v a.
struct Turning {
  float acceleration = 0.0F;  ///< A, mm/s².
  float curvature = 0.0F;     ///< κ ≥ 0, 1/mm.
  float window_s = 0.0F;      ///< T; 0 where jerk is not limited.

  /// v² at which, on a level course, κ v² = A or κ² v³ is four fifths of A / T:
  /// the last fifth is for the way there.
  [[nodiscard]] float speed_limit_square() const;

  /// The greatest a that may hold over `distance` mm from where v² is
  /// `speed_square`, v² growing all the way up to at most `cap_square`.
  [[nodiscard]] float steepest(float distance, float speed_square, float cap_square) const;

  /// The greatest a at this v² as far as jerk goes. @pre window_s > 0
  [[nodiscard]] float within_jerk(float speed_square) const;

 private:
  [[nodiscard]] float within_acceleration(float distance, float speed_square) const;
};

}  // namespace cnc::motion
