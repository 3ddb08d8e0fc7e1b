#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/wide_float.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

/// A control point in homogeneous form: its coordinates multiplied by its weight, and the weight.
struct WeightedPoint {
  Wide x{};  ///< Weight times the coordinate in nanometres; likewise `y`.
  Wide y{};
  Wide weight{1.0F};
};

/// Returns the point that divides the line from a to b at `share` of its length.
[[nodiscard]] WeightedPoint between(const WeightedPoint& a,
                                    const WeightedPoint& b,
                                    const Wide& share);

/// A point in whole nanometres, relative to the origin of the curve.
struct PlanePlace {
  std::int64_t x = 0;
  std::int64_t y = 0;
  constexpr bool operator==(const PlanePlace&) const = default;
};

/// A rational Bézier curve in a plane, with positive weights. If all weights are equal, it is a
/// plain Bézier curve. It stays inside the convex hull of its control points.
class Bezier {
 public:
  static constexpr std::size_t kHighestDegree = 5;

  Bezier() = default;
  /// @pre `degree` is 1…kHighestDegree. Entries of `points` after index `degree` are not used.
  Bezier(const std::array<WeightedPoint, kHighestDegree + 1>& points, std::size_t degree)
      : points_{points}, degree_{degree} {}

  [[nodiscard]] std::size_t degree() const { return degree_; }
  /// Returns a control point. @pre index ≤ degree()
  [[nodiscard]] const WeightedPoint& point(std::size_t index) const { return points_[index]; }

  /// Returns the part of the curve before `parameter`, or the part after it (de Casteljau). Each
  /// part has its own parameter 0…1. Control points are exact within kBezierError, relative to the
  /// farthest control point of the complete curve.
  /// @param parameter 0…1.
  [[nodiscard]] Bezier until(float parameter) const;
  [[nodiscard]] Bezier from(float parameter) const;

  /// Returns the first point of the curve, or its last point, rounded to the nearest nanometre. The
  /// error of kBezierError adds to the rounding.
  [[nodiscard]] PlanePlace start() const { return place_of(points_[0]); }
  [[nodiscard]] PlanePlace end() const { return place_of(points_[degree_]); }

  /// Returns the unit vector of travel at the start, or at the end. If control points coincide
  /// there, the result is the limit; if all coincide, it is null. Control points closer than
  /// kCoincident count as one point.
  [[nodiscard]] Vec2 start_tangent() const;
  [[nodiscard]] Vec2 end_tangent() const;
  /// Distance below which control points count as one point, in nanometres. The finest distance
  /// that G-code writes is 1 nm.
  static constexpr float kCoincident = 0.01F;

  /// Returns a control point after division by its weight, as a point in whole nanometres.
  [[nodiscard]] static PlanePlace place_of(const WeightedPoint& point);

 private:
  std::array<WeightedPoint, kHighestDegree + 1> points_{};
  std::size_t degree_ = 1;
};

/// Error of control points relative to the farthest control point: a nanometre at a kilometre.
inline constexpr double kBezierError = 1.0e-12;

}  // namespace cnc
