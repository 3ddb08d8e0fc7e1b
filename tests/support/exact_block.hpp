#pragma once

#include "planner/geometry/path_element.hpp"

namespace proof {

/// A vector over all axes: mm for X Y Z, degrees for A B C.
using Vector = cnc::AxisArray<double>;

[[nodiscard]] double norm(const Vector& vector);
[[nodiscard]] Vector to_mm(const cnc::Position& position);

/// A path element in double precision, computed from its definition alone: end points, bulge =
/// tan(sweep / 4), other axes in proportion to the arc length. A fraction is a share of the length
/// over all six axes.
class ExactBlock {
 public:
  explicit ExactBlock(const cnc::PathElement& element);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] bool turns() const { return half_sweep_ != 0.0; }
  /// Half of the sweep, radians, positive counter-clockwise.
  [[nodiscard]] double half_sweep() const { return half_sweep_; }
  /// Length of the projection into the plane, mm.
  [[nodiscard]] double plane_length() const { return plane_length_; }
  /// Radius of the circle in the plane, mm; 0 for a line.
  [[nodiscard]] double radius() const;
  /// Ratio of plane_length() to length().
  [[nodiscard]] double plane_share() const { return plane_length_ / length_; }
  [[nodiscard]] const cnc::ArcPlane& plane() const { return plane_; }
  /// Returns the part of a vector that lies in the plane.
  [[nodiscard]] Vector in_plane(const Vector& vector) const;

  [[nodiscard]] Vector place_at(double fraction) const;
  /// Returns the unit direction of travel.
  [[nodiscard]] Vector tangent_at(double fraction) const;
  /// Returns the derivative of the tangent by the length, 1/mm.
  [[nodiscard]] Vector bend_at(double fraction) const;
  /// Returns the length that F counts: that in X Y Z, or in A B C if only these move.
  [[nodiscard]] double feed_length() const;

 private:
  [[nodiscard]] Vector seen_as(double x, double y) const;

  Vector start_{};
  Vector travel_{};
  Vector off_plane_{};  ///< The part of the travel that is not in the plane.
  cnc::ArcPlane plane_;
  Vector first_{};  ///< First unit vector of the plane; `second_` is perpendicular to it.
  Vector second_{};
  double half_sweep_ = 0.0;
  double chord_ = 0.0;
  double chord_angle_ = 0.0;
  double plane_length_ = 0.0;
  double length_ = 0.0;
};

}  // namespace proof
