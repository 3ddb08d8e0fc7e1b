#pragma once

#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc_elements.hpp"

namespace cnc {

using Real = long double;

inline constexpr Real kExactPi = 3.14159265358979323846L;

/// A point in the plane of an arc, mm from its programmed centre.
struct PlanePoint {
  Real first;
  Real second;

  [[nodiscard]] Real radius() const { return std::hypot(first, second); }
  [[nodiscard]] Real angle() const { return std::atan2(second, first); }
};

inline PlanePoint from_centre(const Position& place, const CentreArc& arc) {
  const PlaneAxes axes = axes_of(arc.plane);
  return {static_cast<Real>((place[axes.first] - arc.centre[0]).nanometres()) * 1.0e-6L,
          static_cast<Real>((place[axes.second] - arc.centre[1]).nanometres()) * 1.0e-6L};
}

/// Geometry that follows from the end points and the bulge of an element alone.
class ExactCircle {
 public:
  ExactCircle(const PathElement& element, const CentreArc& arc)
      : start_{from_centre(element.start, arc)},
        end_{from_centre(element.end, arc)},
        bulge_{static_cast<Real>(element.bulge)} {}

  [[nodiscard]] Real half_chord() const {
    return 0.5L * std::hypot(end_.first - start_.first, end_.second - start_.second);
  }
  [[nodiscard]] Real radius() const {
    return half_chord() * (1.0L + bulge_ * bulge_) / (2.0L * std::abs(bulge_));
  }
  /// Returns the height of the centre above the chord, positive to the left.
  [[nodiscard]] Real centre_to_left() const {
    return half_chord() * (1.0L - bulge_ * bulge_) / (2.0L * bulge_);
  }
  /// Returns the height of the point of the bisector that is nearest to the programmed centre.
  [[nodiscard]] Real wanted_to_left() const {
    const PlanePoint middle = middle_of_chord();
    return -(left_first() * middle.first + left_second() * middle.second);
  }
  /// Returns the point at a fraction of the arc length, 0…1.
  [[nodiscard]] PlanePoint at(Real fraction) const {
    const Real half = 2.0L * std::atan(bulge_);
    const Real turned = (2.0L * fraction - 1.0L) * half;
    const Real reach = half_chord() / std::sin(half);
    const Real along = reach * std::sin(turned);
    const Real to_left = -reach * (std::cos(turned) - std::cos(half));
    const PlanePoint middle = middle_of_chord();
    return {middle.first + along * left_second() + to_left * left_first(),
            middle.second - along * left_first() + to_left * left_second()};
  }

 private:
  [[nodiscard]] PlanePoint middle_of_chord() const {
    return {0.5L * (start_.first + end_.first), 0.5L * (start_.second + end_.second)};
  }
  [[nodiscard]] Real left_first() const {
    return -(end_.second - start_.second) / (2.0L * half_chord());
  }
  [[nodiscard]] Real left_second() const {
    return (end_.first - start_.first) / (2.0L * half_chord());
  }

  PlanePoint start_;
  PlanePoint end_;
  Real bulge_;
};

}  // namespace cnc
