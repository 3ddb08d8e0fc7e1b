#pragma once

#include <array>
#include <cstddef>

#include "planner/geometry/bezier_view.hpp"
#include "planner/geometry/spline.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

/// The stretch of a spline that lies ahead of a place on it, in single
/// precision but seen from that place: origin there, x along the tangent, mm.
/// Errors are relative to the stretch of curve and not to the size of the
/// spline: where it has not gone farther than r from there, at most
/// kAheadError · r and a nanometre.
///
/// The distance ahead is in knots, 1 for a whole segment.
class CurveAhead {
 public:
  static constexpr double kAheadError = 4.0e-7;
  /// Segments that are looked at; a biarc seldom spans three.
  static constexpr std::size_t kMostPieces = 4;

  /// At the beginning of the spline, which must outlive this. @pre complete()
  explicit CurveAhead(const Spline& spline) : spline_{&spline} { look(); }

  [[nodiscard]] bool at_end() const { return segment_ >= spline_->segment_count(); }
  /// Where this place is, from the first control point.
  [[nodiscard]] const PlanePlace& place() const { return origin_; }
  /// Unit vector in the plane; +x on a curve without any direction.
  [[nodiscard]] const Vec2& tangent() const { return tangent_; }

  /// How far it can be seen.
  [[nodiscard]] float length() const;
  /// What is seen is all that is left.
  [[nodiscard]] bool sees_end() const { return segment_ + kMostPieces >= spline_->segment_count(); }
  /// The nearest distance to this one that the parameter can express.
  [[nodiscard]] float expressible(float distance) const;

  /// @pre 0 ≤ distance ≤ length()
  [[nodiscard]] CurvePoint at(float distance);
  /// Unit vector with which the curve arrives there; +x if it has none.
  [[nodiscard]] Vec2 arrival(float distance);

  /// Goes there. @pre expressible, 0 < distance ≤ length()
  void advance(float distance);

 private:
  struct Spot {
    std::size_t piece;
    float parameter;  ///< Of the piece, 0…1.
  };

  void look();
  void prepare(std::size_t piece);
  [[nodiscard]] Spot spot(float distance) const;

  const Spline* spline_;
  std::size_t segment_ = 0;
  float parameter_ = 0.0F;  ///< Of the segment, 0…1 without 1.
  PlanePlace origin_{};
  Vec2 tangent_{1.0F, 0.0F};
  std::size_t prepared_ = 0;
  std::array<Bezier, kMostPieces> beziers_{};  ///< The first from `parameter_` on.
  std::array<BezierView, kMostPieces> views_{};
};

}  // namespace cnc
