#pragma once

#include "planner/contour/curve_piece.hpp"
#include "planner/geometry/tangent_circle.hpp"

namespace cnc {

/// An arc of at most half a turn, from its start and its tangent there to its end.
class BoundedArc {
 public:
  BoundedArc(const Vec2D& start, const Vec2D& start_tangent, const Vec2D& end);

  /// Of a place, and how fast that grows along `direction`, which is a unit vector.
  struct Distance {
    double mm = 0.0;
    double slope = 0.0;
  };
  [[nodiscard]] Distance distance(const Vec2D& place, const Vec2D& direction) const;
  [[nodiscard]] bool is_half_a_turn_at_most() const;
  [[nodiscard]] double curvature() const { return circle_.curvature; }
  [[nodiscard]] const Vec2D& start() const { return circle_.point; }
  [[nodiscard]] const Vec2D& end() const { return end_; }

 private:
  TangentCircleD circle_;
  Vec2D end_;
  Vec2D end_tangent_;
};

/// A part of a piece: spans, `from` at most `to`.
struct CurveStretch {
  const CurvePiece* piece = nullptr;
  double from = 0.0;
  double to = 0.0;
};

/// How far an arc and the stretch of a curve beside it are from each other, both ways, mm; a
/// bound, at most `fine_mm` or so above what it is. kNoArcFits where nothing can be said.
///
/// The stretch: places of it are looked at so near to each other that what the distance
/// may rise to between two, by how fast it grows at both, is within `fine_mm`. The arc itself
/// counts, not its circle: a curve that goes back beside it is measured to its ends.
///
/// The arc: as long as the curve is nearer to it than its radius, the place of the arc that is
/// nearest goes on without a jump as the curve does, and so passes every place between those
/// nearest to the stretch's ends. What of the arc is left out is nearer to these than the arc's
/// ends are, whose distance from them counts too.
[[nodiscard]] double arc_deviation(const CurveStretch& stretch,
                                   const BoundedArc& arc,
                                   double fine_mm);
inline constexpr double kNoArcFits = 1.0e9;

}  // namespace cnc
