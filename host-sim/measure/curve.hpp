#pragma once

#include <array>
#include <optional>

#include "planner/geometry/arc_plane.hpp"

namespace sim {

/// A place, a direction or a difference on all six axes: mm for X Y Z, degrees
/// for A B C. Lengths and distances are Euclidean over the six numbers.
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
  /// The part of a vector along either.
  [[nodiscard]] std::array<double, 2> seen(const Point& vector) const;
  /// The part of a vector at right angles to both.
  [[nodiscard]] Point off(const Point& vector) const;
  /// The vector in the plane that is seen so.
  [[nodiscard]] Point vector(const std::array<double, 2>& seen) const;

 private:
  Point first_{};
  Point second_{};
};

/// The round part of an arc or helix, in the two vectors of its plane: in a coordinate plane
/// those of its axes, in the order of axes_of(plane).
struct Circle {
  cnc::ArcPlane plane{};
  PlaneVectors vectors{};
  std::array<double, 2> centre{};  ///< mm.
  double radius = 0.0;             ///< mm.
  double start_angle = 0.0;        ///< Radians from the plane's first vector.
  double sweep = 0.0;              ///< Radians, positive counter-clockwise (G3).
};

struct Bounds {
  Point low{};
  Point high{};
};

/// The point of a curve that is nearest to some other point.
struct Nearest {
  double fraction = 0.0;  ///< Of the curve's length, 0…1.
  double distance = 0.0;
  Point point{};
};

/// A line, or an arc or helix of less than a full turn, in double precision.
///
/// Every axis that is not round moves in proportion to the angle, so a
/// fraction of the length is the same fraction of every axis.
class Curve {
 public:
  /// Start and end may be the same place; such a curve has no direction.
  [[nodiscard]] static Curve line(const Point& start, const Point& end);

  /// Keeps both end points and moves the centre to the nearest point on the
  /// perpendicular bisector of the chord. Owed: start and end differ in the plane.
  [[nodiscard]] static Curve arc(const Point& start,
                                 const Point& end,
                                 const cnc::ArcPlane& plane,
                                 const std::array<double, 2>& centre,
                                 bool clockwise);

  [[nodiscard]] const Point& start() const { return start_; }
  [[nodiscard]] const Point& end() const { return end_; }
  [[nodiscard]] const std::optional<Circle>& circle() const { return circle_; }
  [[nodiscard]] double length() const { return length_; }
  /// Length in X Y Z alone, what F applies to; zero when only A B C move.
  [[nodiscard]] double linear_length() const;

  /// Exact at 0 and at 1.
  [[nodiscard]] Point point_at(double fraction) const;
  /// Unit direction of travel; zero for a curve without length.
  [[nodiscard]] Point tangent_at(double fraction) const;
  /// Change of the unit tangent per length (1/mm); zero for a line.
  [[nodiscard]] Point curvature_at(double fraction) const;
  [[nodiscard]] Bounds bounds() const;

  /// The nearest point of the part from fraction `from` to the end. Closed form
  /// for lines and flat arcs; on a helix to 1e-9 mm by Newton's method, with a
  /// search where that cannot be trusted.
  [[nodiscard]] Nearest nearest(const Point& to, double from = 0.0) const;

 private:
  Curve(const Point& start, const Point& end) : start_{start}, end_{end} {}

  [[nodiscard]] Nearest measured(const Point& to, double fraction) const;
  [[nodiscard]] double nearest_fraction_on_arc(const Point& to, double from) const;
  /// The run off the circle's plane.
  [[nodiscard]] Point run_off_plane() const;
  /// Where the circle is at a fraction, and how it goes on there: from its centre, by radius.
  [[nodiscard]] std::array<double, 2> outward_at(double fraction) const;

  Point start_;
  Point end_;
  std::optional<Circle> circle_;
  double length_ = 0.0;
};

}  // namespace sim
