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

/// Two unit vectors at right angles that span the plane of an arc.
class PlaneVectors {
 public:
  PlaneVectors() : PlaneVectors{cnc::Plane::kXY} {}
  explicit PlaneVectors(const cnc::ArcPlane& plane);

  [[nodiscard]] const Point& first() const { return first_; }
  [[nodiscard]] const Point& second() const { return second_; }
  /// Returns the components of a vector along the two vectors.
  [[nodiscard]] std::array<double, 2> seen(const Point& vector) const;
  /// Returns the part of a vector at right angles to both vectors.
  [[nodiscard]] Point off(const Point& vector) const;
  /// Returns the vector in the plane that has the components `seen`.
  [[nodiscard]] Point vector(const std::array<double, 2>& seen) const;

 private:
  Point first_{};
  Point second_{};
};

/// The circular part of an arc or helix, in the two vectors of its plane. In a coordinate plane
/// they are the vectors of its axes, in the order of axes_of(plane).
struct Circle {
  cnc::ArcPlane plane{};
  PlaneVectors vectors{};
  std::array<double, 2> centre{};  ///< Centre in the plane, mm.
  double radius = 0.0;             ///< Radius, mm.
  double start_angle = 0.0;        ///< Angle of the start from the plane's first vector, radians.
  double sweep = 0.0;              ///< Angle turned, radians; positive counter-clockwise (G3).
};

struct Bounds {
  Point low{};
  Point high{};
};

/// The point of a curve that is nearest to a given point.
struct Nearest {
  double fraction = 0.0;  ///< Share of the curve's length at which the point lies, 0…1.
  double distance = 0.0;
  Point point{};
};

/// A line, or an arc or helix of less than a full turn, in double precision.
///
/// Every axis outside the circle moves in proportion to the angle, so that a fraction of the length
/// is the same fraction of every such axis.
class Curve {
 public:
  /// Returns a line. Start and end may be the same point; such a curve has no direction.
  [[nodiscard]] static Curve line(const Point& start, const Point& end);

  /// Returns an arc. It keeps both end points and moves the centre to the nearest point on the
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
  /// Returns the length in X Y Z alone, to which F applies; zero when only A B C move.
  [[nodiscard]] double linear_length() const;

  /// Returns the point at a fraction of the length. It is exact at 0 and at 1.
  [[nodiscard]] Point point_at(double fraction) const;
  /// Returns the unit direction of travel; zero for a curve without length.
  [[nodiscard]] Point tangent_at(double fraction) const;
  /// Returns the change of the unit tangent per length (1/mm); zero for a line.
  [[nodiscard]] Point curvature_at(double fraction) const;
  [[nodiscard]] Bounds bounds() const;

  /// Returns the nearest point of the part from fraction `from` to the end. Lines and flat arcs
  /// have a closed form. A helix is solved to 1e-9 mm by Newton's method, and by a search where
  /// that method is not reliable.
  [[nodiscard]] Nearest nearest(const Point& to, double from = 0.0) const;

 private:
  Curve(const Point& start, const Point& end) : start_{start}, end_{end} {}

  [[nodiscard]] Nearest measured(const Point& to, double fraction) const;
  [[nodiscard]] double nearest_fraction_on_arc(const Point& to, double from) const;
  /// Returns the part of the run at right angles to the circle's plane.
  [[nodiscard]] Point run_off_plane() const;
  /// Returns the point of the circle at a fraction, relative to its centre and divided by its
  /// radius.
  [[nodiscard]] std::array<double, 2> outward_at(double fraction) const;

  Point start_;
  Point end_;
  std::optional<Circle> circle_;
  double length_ = 0.0;
};

}  // namespace sim
