#include "host-sim/cut/contour_size.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "host-sim/import/curve_measure.hpp"

namespace sim::cut {
namespace {

using drawing::Place;

/// Distance by which a point may be outside of a circle and still count as inside, as a share of
/// the radius of the circle.
constexpr double kOnCircle = 1.0e-12;
/// Arcs whose centres and radii agree within this distance belong to one circle, mm.
constexpr double kSameCircleMm = 1.0e-6;

struct Circle {
  Place centre{0.0, 0.0};
  double radius = -1.0;

  [[nodiscard]] bool holds(const Place& place) const {
    return radius >= 0.0 &&
           drawing::distance(centre, place) <= radius * (1.0 + kOnCircle) + 1.0e-12;
  }
};

Circle around(const Place& a, const Place& b) {
  return {0.5 * (a + b), 0.5 * drawing::distance(a, b)};
}

/// Returns the circle through three points. If the points are on a line, returns the smallest
/// circle around the two points that are farthest apart.
Circle around(const Place& a, const Place& b, const Place& c) {
  const Place ab = b - a;
  const Place ac = c - a;
  const double twice = 2.0 * drawing::cross(ab, ac);
  if (std::abs(twice) <= 1.0e-15 * (ab.squaredNorm() + ac.squaredNorm())) {
    const std::array circles{around(a, b), around(b, c), around(a, c)};
    return *std::ranges::max_element(circles, {}, &Circle::radius);
  }
  const Place way{(ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm()) / twice,
                  (ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm()) / twice};
  return {a + way, way.norm()};
}

/// Shuffles points in the same way on every machine. Points in the order of a curve would make the
/// search for the smallest circle take n³ steps for n points.
void shuffle(std::vector<Place>& places) {
  std::uint64_t state = 1;
  for (std::size_t i = places.size(); i > 1; --i) {
    state = state * 6'364'136'223'846'793'005U + 1'442'695'040'888'963'407U;
    std::swap(places[i - 1], places[(state >> 33U) % i]);
  }
}

/// Returns the diameter of a contour that is a circle; nothing for any other contour.
std::optional<double> own_diameter(const drawing::DrawnContour& contour) {
  const auto* const first = std::get_if<drawing::Arc>(&contour.shapes.front());
  if (first == nullptr || !contour.closed) return {};
  const double radius = drawing::distance(first->start, first->centre);
  for (const drawing::Shape& shape : contour.shapes) {
    const auto* const arc = std::get_if<drawing::Arc>(&shape);
    if (arc == nullptr || drawing::distance(arc->centre, first->centre) > kSameCircleMm) return {};
    if (std::abs(drawing::distance(arc->start, arc->centre) - radius) > kSameCircleMm) return {};
  }
  return 2.0 * radius;
}

}  // namespace

double enclosing_diameter(std::vector<Place> places) {
  shuffle(places);
  Circle circle;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (circle.holds(places[i])) continue;
    circle = {places[i], 0.0};
    for (std::size_t j = 0; j < i; ++j) {
      if (circle.holds(places[j])) continue;
      circle = around(places[i], places[j]);
      for (std::size_t k = 0; k < j; ++k) {
        if (!circle.holds(places[k])) circle = around(places[i], places[j], places[k]);
      }
    }
  }
  return 2.0 * std::max(circle.radius, 0.0);
}

double diameter_of(const drawing::DrawnContour& contour) {
  if (const auto diameter = own_diameter(contour)) return *diameter;
  return enclosing_diameter(drawing::outline_of(contour.shapes, drawing::kChordToleranceMm));
}

}  // namespace sim::cut
