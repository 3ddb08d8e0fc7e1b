#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "planner/geometry/vector.hpp"

namespace cnc::path {

/// A circle through the origin: its curvature and direction there, both divided
/// by the cosine of the angle between that direction and +x.
struct FanCircle {
  float curvature = 0.0F;  ///< 1/mm.
  float slope = 0.0F;      ///< Of the tangent at the origin.
};

/// All circles through the origin that pass a growing list of points within a
/// distance, as a convex polygon of their curvature and slope. The points
/// themselves are not kept.
///
/// A circle through the origin with the direction (1, t) and the curvature k,
/// both over √(1 + t²), is within Q of the point (x, y) exactly if
///   |k (x² + y² − Q²) + 2 t x − 2 y| ≤ 2 Q √(1 + t²),
/// and here √ is taken for 1, which only makes the polygon smaller. Each point
/// is two half planes that cut it.
///
/// A circle in space is two of these, of x and y and of x and z. With the direction (1, t, u) and
/// the curvature vector k, less the multiple of the direction that has the same part along x,
/// it is within Q of the point p = (x, y, z) if
///   |k_y (|p|² − Q²) + 2 t x − 2 y| ≤ 2 Q_y and |k_z (|p|² − Q²) + 2 u x − 2 z| ≤ 2 Q_z
/// where Q_y² + Q_z² = Q²: both together are twice the vector from p to the circle's plane and, in
/// that plane, to the circle, where Q is measured from its far side; and what is taken from it only
/// makes it longer.
class CircleFan {
 public:
  /// Slopes up to this, either way: 31°.
  static constexpr float kSteepest = 0.6F;

  /// All circles again. @param most_curvature 1/mm.
  void open(float most_curvature);
  [[nodiscard]] bool empty() const { return count_ < 3; }

  /// Cuts away the circles that are farther than this from the point.
  /// @param weight |p|² − Q²; at an end of a chord less, by a quarter of the chord's square, as the
  /// chord lies on the side of the centre, by chord² / 8 of the curvature
  /// @param within_mm Q, or the part of it along y; at least 1e-6.
  void pass(const Vec2& point, float weight, float within_mm);

  /// Of the circles through a point: the span from one slope to another.
  struct Through {
    FanCircle low;
    FanCircle high;

    [[nodiscard]] FanCircle middle() const {
      return {.curvature = 0.5F * (low.curvature + high.curvature),
              .slope = 0.5F * (low.slope + high.slope)};
    }
    [[nodiscard]] bool has_straight() const { return low.curvature * high.curvature <= 0.0F; }
    [[nodiscard]] bool has_level() const { return low.slope <= 0.0F && high.slope >= 0.0F; }
  };
  /// @param weight |p|²
  [[nodiscard]] std::optional<Through> through(const Vec2& point, float weight) const;

 private:
  static constexpr std::size_t kMostCorners = 16;

  void keep(float by_curvature, float by_slope, float most);
  void cut(std::size_t first, std::size_t past);
  void drop_smallest();

  std::array<FanCircle, kMostCorners + 1> corners_{};
  /// By how much each is beyond the half plane that is being kept.
  std::array<float, kMostCorners + 1> excess_{};
  std::size_t count_ = 0;
};

}  // namespace cnc::path
