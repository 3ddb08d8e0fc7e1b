#pragma once

#include <array>
#include <cstddef>

#include "planner/geometry/bezier_view.hpp"
#include "planner/geometry/spline.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

/// The part of a spline ahead of a point on it, in single precision and in mm. The frame is that of
/// the point: the point is the origin, and x is along the tangent at the point. Errors are relative
/// to this part of the curve and not to the size of the spline. As long as the curve has stayed
/// within the distance r of the point, the error is at most kAheadError · r plus a nanometre.
///
/// The distance ahead is in knots: 1 stands for a whole segment.
class CurveAhead {
 public:
  static constexpr double kAheadError = 4.0e-7;
  /// Greatest number of segments in view. A biarc seldom extends over three segments.
  static constexpr std::size_t kMaxPieces = 4;

  /// Starts at the beginning of the spline. The spline must outlive this object. @pre
  /// spline.complete()
  explicit CurveAhead(const Spline& spline) : spline_{&spline} { look(); }

  [[nodiscard]] bool at_end() const { return segment_ >= spline_->segment_count(); }
  /// Returns the present point on the curve, relative to the first control point.
  [[nodiscard]] const PlanePlace& place() const { return origin_; }
  /// Returns the unit tangent at the present point; +x if the curve has no direction.
  [[nodiscard]] const Vec2& tangent() const { return tangent_; }

  /// Returns the length of the curve in view, in knots.
  [[nodiscard]] float length() const;
  /// Returns whether the view includes the end of the spline.
  [[nodiscard]] bool sees_end() const { return segment_ + kMaxPieces >= spline_->segment_count(); }
  /// Returns the distance nearest to `distance` that the parameter can represent exactly.
  [[nodiscard]] float expressible(float distance) const;

  /// Returns the point of the curve at `distance` ahead of the present point. @pre 0 ≤ distance ≤
  /// length()
  [[nodiscard]] CurvePoint at(float distance);
  /// Returns the direction in which the curve arrives at the point `distance` ahead, a unit vector;
  /// +x if the curve has no direction.
  [[nodiscard]] Vec2 arrival(float distance);

  /// Moves the present point ahead by `distance`. @pre expressible(distance) == distance, 0 <
  /// distance ≤ length()
  void advance(float distance);

 private:
  struct Spot {
    std::size_t piece;
    float parameter;  ///< Parameter of the piece, 0…1.
  };

  void look();
  void prepare(std::size_t piece);
  [[nodiscard]] Spot spot(float distance) const;

  const Spline* spline_;
  std::size_t segment_ = 0;
  float parameter_ = 0.0F;  ///< Parameter of the segment, 0…1, with 1 excluded.
  PlanePlace origin_{};
  Vec2 tangent_{1.0F, 0.0F};
  std::size_t prepared_ = 0;
  /// Bézier curves of the segments in view. The first curve begins at the present point, at
  /// `parameter_` of its segment.
  std::array<Bezier, kMaxPieces> beziers_{};
  std::array<BezierView, kMaxPieces> views_{};
};

}  // namespace cnc
