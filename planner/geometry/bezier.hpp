#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/wide_float.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

/// A control point times its weight, and the weight.
struct WeightedPoint {
  Wide x{};  ///< Weight · nanometres.
  Wide y{};
  Wide weight{1.0F};
};

/// The point at `share` of the way from a to b.
[[nodiscard]] WeightedPoint between(const WeightedPoint& a,
                                    const WeightedPoint& b,
                                    const Wide& share);

/// A place in whole nanometres, relative to wherever the curve counts from.
struct PlanePlace {
  std::int64_t x = 0;
  std::int64_t y = 0;
  constexpr bool operator==(const PlanePlace&) const = default;
};

/// A rational Bézier curve in a plane, with positive weights; a plain one where
/// all are equal. It stays inside the hull of its control points.
class Bezier {
 public:
  static constexpr std::size_t kHighestDegree = 5;

  Bezier() = default;
  /// @pre degree is 1…kHighestDegree; points above it mean nothing.
  Bezier(const std::array<WeightedPoint, kHighestDegree + 1>& points, std::size_t degree)
      : points_{points}, degree_{degree} {}

  [[nodiscard]] std::size_t degree() const { return degree_; }
  /// @pre index ≤ degree()
  [[nodiscard]] const WeightedPoint& point(std::size_t index) const { return points_[index]; }

  /// The part before `parameter`, and the part from there on, each with the
  /// parameter 0…1 again (de Casteljau). Control points are within
  /// kBezierError of the greatest control point of the whole.
  /// @param parameter 0…1.
  [[nodiscard]] Bezier until(float parameter) const;
  [[nodiscard]] Bezier from(float parameter) const;

  /// Where the curve begins and ends, to the nearest nanometre but for
  /// kBezierError.
  [[nodiscard]] PlanePlace start() const { return place_of(points_[0]); }
  [[nodiscard]] PlanePlace end() const { return place_of(points_[degree_]); }

  /// Unit vector of travel at the start and at the end; where control points
  /// coincide there, the limit. Null when all coincide. Control points closer
  /// than kCoincident count as one.
  [[nodiscard]] Vec2 start_tangent() const;
  [[nodiscard]] Vec2 end_tangent() const;
  static constexpr float kCoincident = 0.01F;  ///< Nanometres: the finest that G-code writes is 1.

  /// A control point without its weight, as a place.
  [[nodiscard]] static PlanePlace place_of(const WeightedPoint& point);

 private:
  std::array<WeightedPoint, kHighestDegree + 1> points_{};
  std::size_t degree_ = 1;
};

/// Relative to the farthest control point: a nanometre at a kilometre.
inline constexpr double kBezierError = 1.0e-12;

}  // namespace cnc
