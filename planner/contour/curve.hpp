#pragma once

#include <algorithm>
#include <cmath>

#include "planner/geometry/arc.hpp"

namespace cnc::contour {

/// A box with its sides along the axes, mm.
template <typename Scalar>
struct FlatBox {
  Scalar x0{};
  Scalar y0{};
  Scalar x1{};
  Scalar y1{};

  [[nodiscard]] bool meets(const FlatBox& other) const {
    return (x0 <= other.x1) & (other.x0 <= x1) & (y0 <= other.y1) & (other.y0 <= y1);
  }
  void include(const FlatBox& other) {
    x0 = std::min(x0, other.x0);
    y0 = std::min(y0, other.y0);
    x1 = std::max(x1, other.x1);
    y1 = std::max(y1, other.y1);
  }
};

/// An arc of at most half a turn, prepared for many queries: ends, tangents and curvature. It
/// stores no centre, so a line needs no separate case and a nearly straight arc loses no digits.
///
/// Let q be the vector from the start to a point. Then f(q) = κ q² − 2 t × q is zero on the circle.
/// The distance from the circle, positive on the right, is f / (1 + √(1 + κ f)).
template <typename Scalar>
struct Curve {
  using Vector = BasicVec2<Scalar>;

  Vector start{Scalar{0}, Scalar{0}};
  Vector end{Scalar{0}, Scalar{0}};
  Vector start_tangent{Scalar{1}, Scalar{0}};
  Vector end_tangent{Scalar{1}, Scalar{0}};
  Scalar curvature{};  ///< Curvature, 1/mm, positive turns left.

  /// Returns twice the distance from the circle, positive on the right, times (1 + distance/2R).
  /// Its sign is exact.
  [[nodiscard]] Scalar side(const Vector& place) const {
    const Vector q = place - start;
    return curvature * q.squaredNorm() - Scalar{2} * cross(start_tangent, q);
  }

  /// Returns whether the point of the circle nearest to `place` is between the curve's ends, within
  /// `slack` mm.
  [[nodiscard]] bool faces(const Vector& place, Scalar slack) const {
    return start_tangent.dot(place - start) >= -slack && end_tangent.dot(place - end) <= slack;
  }

  /// Returns the distance from the circle, mm, never negative.
  [[nodiscard]] Scalar from_circle(const Vector& place) const {
    const Scalar f = side(place);
    if (curvature == Scalar{0}) return Scalar{0.5} * std::abs(f);
    return std::abs(f) / (Scalar{1} + std::sqrt(std::max(Scalar{0}, Scalar{1} + curvature * f)));
  }

  [[nodiscard]] Scalar distance(const Vector& place) const {
    if (faces(place, Scalar{0})) return from_circle(place);
    return std::sqrt(std::min((place - start).squaredNorm(), (place - end).squaredNorm()));
  }

  /// Returns the unit direction of travel at a point of the circle.
  [[nodiscard]] Vector tangent_at(const Vector& place) const {
    if (curvature == Scalar{0}) return start_tangent;
    return (start_tangent + curvature * left_normal(place - start)).normalized();
  }

  /// Returns the bulge of the part between two points of the curve that are given in order; 0 if
  /// both are one point.
  [[nodiscard]] Scalar bulge_between(const Vector& from, const Vector& to) const {
    const Vector chord = to - from;
    if (curvature == Scalar{0} || chord == Vector{Scalar{0}, Scalar{0}}) return Scalar{0};
    const Vector tangent = tangent_at(from);
    return cross(tangent, chord) / (chord.norm() + tangent.dot(chord));
  }

  [[nodiscard]] Vector middle_between(const Vector& from, const Vector& to) const {
    const Vector chord = to - from;
    return Scalar{0.5} * (from + to - bulge_between(from, to) * left_normal(chord));
  }

  /// Returns a measure that grows along the curve from 0 at the start to 1 at the end. It grows
  /// everywhere fast enough to distinguish two points. The distance from the start alone would lose
  /// digits near half a turn.
  [[nodiscard]] Scalar order_of(const Vector& place) const {
    const Scalar behind = (place - start).norm();
    const Scalar whole = behind + (place - end).norm();
    return whole > Scalar{0} ? behind / whole : Scalar{0};
  }

  /// Returns a box around the curve. Each side of the box is too far out by at most the height of
  /// the arc.
  [[nodiscard]] FlatBox<Scalar> box() const;
};

template <typename Scalar>
[[nodiscard]] Curve<Scalar> curve_of(const BasicArc<Scalar>& arc) {
  return {arc.start(), arc.end(), arc.start_tangent(), arc.end_tangent(), arc.curvature()};
}

}  // namespace cnc::contour
