#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "planner/geometry/vector.hpp"

namespace cnc::path {

/// A circle through the origin, given by its curvature and its direction at the origin. Both are
/// divided by the cosine of the angle between this direction and +x. So the direction is written as
/// (1, slope).
struct FanCircle {
  float curvature = 0.0F;  ///< Curvature, divided by the cosine, 1/mm.
  float slope = 0.0F;      ///< Slope of the tangent at the origin.
};

/// The set of all circles through the origin that pass each point of a growing list within a
/// distance. It is represented by a convex polygon of curvatures and slopes. The points themselves
/// are not stored.
///
/// A circle through the origin has the direction (1, t) and the curvature k, both divided by √(1 +
/// t²). It is within Q of the point (x, y) exactly if
///   |k (x² + y² − Q²) + 2 t x − 2 y| ≤ 2 Q √(1 + t²).
/// Here √(1 + t²) is replaced by 1, which only makes the polygon smaller. Each point gives two half
/// planes that cut the polygon.
///
/// A circle in space is represented by two of these fans: one of x and y, and one of x and z. Let
/// its direction be (1, t, u). Let k be its curvature vector, minus the multiple of the direction
/// that has the same component along x. The circle is within Q of the point p = (x, y, z) if
///   |k_y (|p|² − Q²) + 2 t x − 2 y| ≤ 2 Q_y and |k_z (|p|² − Q²) + 2 u x − 2 z| ≤ 2 Q_z,
/// where Q_y² + Q_z² = Q². The two terms between bars are the components of a vector. That vector
/// is twice the distance vector from p to the plane of the circle and, within that plane, to the
/// circle. There, Q is measured from the far side of the circle. Subtracting the multiple of the
/// direction only makes the vector longer.
class CircleFan {
 public:
  /// Greatest magnitude of the slope, which corresponds to 31°.
  static constexpr float kSteepest = 0.6F;

  /// Resets the set to all circles up to a curvature. @param max_curvature in 1/mm
  void open(float max_curvature);
  [[nodiscard]] bool empty() const { return count_ < 3; }

  /// Removes the circles whose distance from `point` exceeds `within_mm`.
  /// @param weight |p|² − Q². If the point is an end of a chord, the weight is smaller by chord² /
  /// 4. The reason is that the middle of the chord is nearer to the circle's centre, by chord² / 8
  /// times the curvature.
  /// @param within_mm Q, or its component along y; at least 1e-6
  void pass(const Vec2& point, float weight, float within_mm);

  /// Removes the circles with `along` + `beside` · t < 0, where t is the slope. If `along` and
  /// `beside` are the coordinates of a point, these circles leave the origin away from this point.
  void keep_ahead(float along, float beside) { keep(0.0F, -beside, along); }

  /// The circles of the set through a point. They are all circles between the one with the lowest
  /// slope and the one with the highest slope.
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
  /// Returns the circles of the set through a point, or nothing if there are none. @param weight
  /// |p|²
  [[nodiscard]] std::optional<Through> through(const Vec2& point, float weight) const;

 private:
  static constexpr std::size_t kMaxCorners = 16;

  void keep(float by_curvature, float by_slope, float most);
  void cut(std::size_t first, std::size_t past);
  void drop_smallest();

  std::array<FanCircle, kMaxCorners + 1> corners_{};
  /// Distance by which each corner is outside the half plane that is being applied; negative
  /// inside.
  std::array<float, kMaxCorners + 1> excess_{};
  std::size_t count_ = 0;
};

}  // namespace cnc::path
