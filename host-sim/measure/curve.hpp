#pragma once

#include <array>
#include <optional>

#include "planner/geometry/arc_plane.hpp"

namespace sim {

/// A position, a direction or a difference on all six axes: mm for X Y Z, degrees for A B C.
/// Lengths and distances are Euclidean over the six numbers.
using Point = cnc::AxisArray<double>;

[[nodiscard]] Point operator-(const Point& a, const Point& b);
[[nodiscard]] double dot(const Point& a, const Point& b);
[[nodiscard]] double norm(const Point& a);
[[nodiscard]] double distance(const Point& a, const Point& b);

/// Two perpendicular unit vectors that span the plane of an arc.
class PlaneVectors {
 public:
  PlaneVectors() : PlaneVectors{cnc::Plane::kXY} {}
  explicit PlaneVectors(const cnc::ArcPlane& plane);

  [[nodiscard]] const Point& first() const { return first_; }
  [[nodiscard]] const Point& second() const { return second_; }
  /// Returns the components of `vector` along the first and the second vector of the plane.
  [[nodiscard]] std::array<double, 2> seen(const Point& vector) const;
  /// Returns the part of `vector` that is perpendicular to the plane.
  [[nodiscard]] Point off(const Point& vector) const;
  /// Returns the vector in the plane that has the components `seen`.
  [[nodiscard]] Point vector(const std::array<double, 2>& seen) const;

 private:
  Point first_{};
  Point second_{};
};

/// The circular part of an arc or a helix, in the coordinates of its plane. In a coordinate plane,
/// the two vectors of the plane are the directions of its axes, in the order of axes_of(plane).
struct Circle {
  cnc::ArcPlane plane{};
  PlaneVectors vectors{};
  std::array<double, 2> centre{};  ///< Centre in the plane's coordinates, mm.
  double radius = 0.0;             ///< Radius, mm.
  /// Angle of the start, counted from the plane's first vector, radians.
  double start_angle = 0.0;
  double sweep = 0.0;  ///< Angle of the arc, radians; positive counter-clockwise (G3).
};

struct Bounds {
  Point low{};
  Point high{};
};

/// The point of a curve that is nearest to a given point.
struct Nearest {
  double fraction = 0.0;  ///< Position of the point as a share of the curve's length, 0…1.
  double distance = 0.0;
  Point point{};
};

/// A line, or an arc or a helix of less than a full turn, in double precision.
///
/// Every axis outside the circle moves in proportion to the angle. Therefore a fraction of the
/// length is the same fraction of the motion of every such axis.
class Curve {
 public:
  /// Returns a line. Start and end may be the same point; then the curve has no direction.
  [[nodiscard]] static Curve line(const Point& start, const Point& end);

  /// Returns an arc. The arc keeps both end points and moves the centre to the nearest point on the
  /// perpendicular bisector of the chord.
  /// @pre start and end differ in the plane
  [[nodiscard]] static Curve arc(const Point& start,
                                 const Point& end,
                                 const cnc::ArcPlane& plane,
                                 const std::array<double, 2>& centre,
                                 bool clockwise);

  [[nodiscard]] const Point& start() const { return start_; }
  [[nodiscard]] const Point& end() const { return end_; }
  [[nodiscard]] const std::optional<Circle>& circle() const { return circle_; }
  [[nodiscard]] double length() const { return length_; }
  /// Returns the length in X Y Z alone, to which F applies; 0 if only A B C move.
  [[nodiscard]] double linear_length() const;

  /// Returns the point at a fraction of the length. The result is exact at 0 and at 1.
  [[nodiscard]] Point point_at(double fraction) const;
  /// Returns the unit vector of travel; the null vector for a curve without length.
  [[nodiscard]] Point tangent_at(double fraction) const;
  /// Returns the change of the unit tangent per length (1/mm); the null vector for a line.
  [[nodiscard]] Point curvature_at(double fraction) const;
  [[nodiscard]] Bounds bounds() const;

  /// Returns the point nearest to `to` on the part of the curve from the fraction `from` to the
  /// end. Lines and flat arcs have a closed form. For a helix, Newton's method finds the point
  /// within 1e-9 mm. Where Newton's method is not reliable, a search follows.
  [[nodiscard]] Nearest nearest(const Point& to, double from = 0.0) const;

 private:
  Curve(const Point& start, const Point& end) : start_{start}, end_{end} {}

  [[nodiscard]] Nearest measured(const Point& to, double fraction) const;
  [[nodiscard]] double nearest_fraction_on_arc(const Point& to, double from) const;
  /// Returns the part of the vector from start to end that is perpendicular to the circle's plane.
  [[nodiscard]] Point run_off_plane() const;
  /// Returns the unit vector from the circle's centre to the point at a fraction.
  [[nodiscard]] std::array<double, 2> outward_at(double fraction) const;

  Point start_;
  Point end_;
  std::optional<Circle> circle_;
  double length_ = 0.0;
};

}  // namespace sim
