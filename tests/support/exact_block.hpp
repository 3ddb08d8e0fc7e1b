#pragma once

#include "planner/geometry/path_element.hpp"

namespace proof {

/// mm of X Y Z and degrees of A B C.
using Vector = cnc::AxisArray<double>;

[[nodiscard]] double norm(const Vector& vector);
[[nodiscard]] Vector to_mm(const cnc::Position& position);

/// A path element in double precision, written anew from its definition: end
/// points, bulge = tan(sweep / 4), other axes in proportion to the arc length.
/// Fractions are of the length in all six axes.
class ExactBlock {
 public:
  explicit ExactBlock(const cnc::PathElement& element);

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] bool turns() const { return half_sweep_ != 0.0; }
  /// Radians, positive counter-clockwise.
  [[nodiscard]] double half_sweep() const { return half_sweep_; }
  /// Length of what it is in its plane.
  [[nodiscard]] double plane_length() const { return plane_length_; }
  /// Of the plane circle, mm; 0 for a line.
  [[nodiscard]] double radius() const;
  /// Plane length / length.
  [[nodiscard]] double plane_share() const { return plane_length_ / length_; }
  [[nodiscard]] const cnc::ArcPlane& plane() const { return plane_; }
  /// The part of a vector that lies in it.
  [[nodiscard]] Vector in_plane(const Vector& vector) const;

  [[nodiscard]] Vector place_at(double fraction) const;
  /// Unit direction of travel.
  [[nodiscard]] Vector tangent_at(double fraction) const;
  /// d tangent / d length, 1/mm.
  [[nodiscard]] Vector bend_at(double fraction) const;
  /// Length in X Y Z alone, or in A B C where those alone move: what F counts.
  [[nodiscard]] double feed_length() const;

 private:
  [[nodiscard]] Vector seen_as(double x, double y) const;

  Vector start_{};
  Vector travel_{};
  Vector off_plane_{};  ///< The part of the travel that is not in the plane.
  cnc::ArcPlane plane_;
  Vector first_{};  ///< Unit vectors of the plane.
  Vector second_{};
  double half_sweep_ = 0.0;
  double chord_ = 0.0;
  double chord_angle_ = 0.0;
  double plane_length_ = 0.0;
  double length_ = 0.0;
};

}  // namespace proof
