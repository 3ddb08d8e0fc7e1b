#include <cmath>

#include "tests/support/contour_oracle.hpp"

namespace proof {
namespace {

using Element = ExactContour::Element;

/// Distance within which two points count as one; check_offset allows the same.
constexpr double kSamePoint_mm = 1.0e-6;

struct Point {
  double x, y;
};

double apart(double x0, double y0, double x1, double y1) { return std::hypot(x1 - x0, y1 - y0); }

bool is_end(const Element& element, const Point& point) {
  return apart(element.x0, element.y0, point.x, point.y) <= kSamePoint_mm ||
         apart(element.x1, element.y1, point.x, point.y) <= kSamePoint_mm;
}

/// Returns whether a point of the element's line or circle is on the element itself. An arc of at
/// most half a turn lies between the perpendiculars at the ends of its chord, on one side of the
/// centre.
bool covers(const Element& element, const Point& point) {
  const double dx = element.x1 - element.x0;
  const double dy = element.y1 - element.y0;
  const double along = (point.x - element.x0) * dx + (point.y - element.y0) * dy;
  if (along < 0.0 || along > dx * dx + dy * dy) return false;
  const double left = dx * (point.y - element.centre_y) - dy * (point.x - element.centre_x);
  return element.radius == 0.0 || (element.sweep > 0.0 ? left <= 0.0 : left >= 0.0);
}

bool meet_at(const Element& one, const Element& other, const Point& point) {
  if (!covers(one, point) || !covers(other, point)) return false;
  return !is_end(one, point) || !is_end(other, point);
}

/// Checks the two points of a line that are `reach` times its direction (dx, dy) away from `foot`.
/// If the square of `reach` is negative, there are no such points.
bool meet_around(const Element& one,
                 const Element& other,
                 const Point& foot,
                 double dx,
                 double dy,
                 double reach_squared) {
  if (!(reach_squared >= 0.0)) return false;
  const double reach = std::sqrt(reach_squared);
  return meet_at(one, other, {foot.x + reach * dx, foot.y + reach * dy}) ||
         meet_at(one, other, {foot.x - reach * dx, foot.y - reach * dy});
}

bool lines_meet(const Element& one, const Element& other) {
  const double dx = one.x1 - one.x0;
  const double dy = one.y1 - one.y0;
  const double other_dx = other.x1 - other.x0;
  const double other_dy = other.y1 - other.y0;
  const double sine = dx * other_dy - dy * other_dx;
  if (sine == 0.0) return false;
  const double share = ((other.x0 - one.x0) * other_dy - (other.y0 - one.y0) * other_dx) / sine;
  return meet_at(one, other, {one.x0 + share * dx, one.y0 + share * dy});
}

bool line_and_arc_meet(const Element& line, const Element& arc) {
  const double dx = line.x1 - line.x0;
  const double dy = line.y1 - line.y0;
  const double square = dx * dx + dy * dy;
  const double share = ((arc.centre_x - line.x0) * dx + (arc.centre_y - line.y0) * dy) / square;
  const Point foot{line.x0 + share * dx, line.y0 + share * dy};
  const double height = apart(arc.centre_x, arc.centre_y, foot.x, foot.y);
  const double room = (arc.radius - height) * (arc.radius + height);
  return meet_around(line, arc, foot, dx, dy, room / square);
}

/// Computed from the smaller circle, because the coordinates of its centre are more exact.
bool arcs_meet(const Element& small, const Element& large) {
  const double dx = large.centre_x - small.centre_x;
  const double dy = large.centre_y - small.centre_y;
  const double square = dx * dx + dy * dy;
  // Both circles are one, or one lies within the other.
  if (square <= kSamePoint_mm * kSamePoint_mm) return false;
  const double difference = (small.radius - large.radius) * (small.radius + large.radius);
  const double share = 0.5 + 0.5 * difference / square;
  const Point foot{small.centre_x + share * dx, small.centre_y + share * dy};
  return meet_around(
      small, large, foot, -dy, dx, small.radius * small.radius / square - share * share);
}

bool meet(const Element& one, const Element& other) {
  // No point of an element is farther from its start than its length.
  if (apart(one.x0, one.y0, other.x0, other.y0) > one.length() + other.length()) return false;
  if (one.radius == 0.0 && other.radius == 0.0) return lines_meet(one, other);
  if (one.radius == 0.0) return line_and_arc_meet(one, other);
  if (other.radius == 0.0) return line_and_arc_meet(other, one);
  return one.radius <= other.radius ? arcs_meet(one, other) : arcs_meet(other, one);
}

}  // namespace

bool elements_cross(const ExactContour& contour) {
  const auto& elements = contour.elements();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    for (std::size_t k = i + 1; k < elements.size(); ++k) {
      if (meet(elements[i], elements[k])) return true;
    }
  }
  return false;
}

}  // namespace proof
