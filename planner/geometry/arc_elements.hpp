#pragma once

#include <array>
#include <cstdint>

#include "planner/geometry/path_element.hpp"

namespace cnc {

/// An arc, circle or helix as G2 and G3 describe it. It is a full circle if its ends are one point
/// in the plane, and also if its end, at most a micrometre away from the start, would be reached by
/// a turn of less than 5e-7: such an end was rounded (Grbl draws the line at the same angle, but at
/// any distance: there a flat arc on a radius of 100 m becomes a circle).
struct CentreArc {
  Position start{};
  Position end{};
  Plane plane = Plane::kXY;
  std::array<Coordinate, 2> centre{};  ///< In the order of axes_of(plane).
  bool clockwise = false;
  std::uint16_t turns = 1;  ///< Up to one full circle, plus turns − 1 whole ones.
};

/// Divides such an arc into path elements of at most half a turn, equal in
/// angle: one for most arcs, two for a full circle, and more where more are asked for.
///
/// Start and end are kept exactly even where rounded numbers put them on
/// slightly different radii. Inner ends lie on the programmed centre at a
/// radius between the two in proportion to the angle, and each element's own
/// centre moves to the nearest point on the perpendicular bisector of its
/// chord: the arc repair. Refusing a deviation that is too large is the
/// business of whoever read the numbers.
class ArcElements {
 public:
  explicit ArcElements(const CentreArc& arc, std::uint32_t least_count = 1) noexcept;

  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// @pre index < count()
  [[nodiscard]] PathElement element(std::uint32_t index) const;

  /// Total angle in radians, positive, whole turns included.
  [[nodiscard]] float sweep() const { return sweep_; }

 private:
  [[nodiscard]] Position division(std::uint32_t index) const;
  [[nodiscard]] float bulge_of(const PathElement& element) const;

  CentreArc arc_;
  PlaneAxes axes_;
  float start_radius_ = 0.0F;
  float end_radius_ = 0.0F;
  float start_cosine_ = 1.0F;
  float start_sine_ = 0.0F;
  float partial_turn_ = 0.0F;  ///< Radians in (0, 2π], without the whole turns.
  float sweep_ = 0.0F;
  std::uint32_t count_ = 1;
};

}  // namespace cnc
