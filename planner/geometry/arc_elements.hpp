#pragma once

#include <array>
#include <cstdint>

#include "planner/geometry/path_element.hpp"

namespace cnc {

/// An arc, circle or helix as G2 and G3 describe it. It is a full circle if start and end are one
/// point in the plane. It is also a full circle if the end is at most a micrometre from the start
/// and the arc would turn by at most 5e-7 rad: such an end was rounded. (Grbl decides by the same
/// angle but at any distance, so in Grbl a flat arc with a radius of 100 m becomes a circle.)
struct CentreArc {
  Position start{};
  Position end{};
  Plane plane = Plane::kXY;
  std::array<Coordinate, 2> centre{};  ///< Coordinates in the order of axes_of(plane).
  bool clockwise = false;
  /// Number of turns: 1 for up to one full circle; each further turn adds a full circle.
  std::uint16_t turns = 1;
};

/// Divides a CentreArc into path elements of equal angle and at most half a turn. The count is one
/// for most arcs and two for a full circle, or `min_count` if that is more.
///
/// Start and end are kept exactly, even if rounding put them on slightly different radii. The
/// radius of the inner division points about the programmed centre changes from the start's to the
/// end's radius in proportion to the angle. The centre of each element moves to the nearest point
/// on the perpendicular bisector of its chord: the arc repair. The caller must refuse an arc whose
/// deviation is too large.
class ArcElements {
 public:
  explicit ArcElements(const CentreArc& arc, std::uint32_t min_count = 1) noexcept;

  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// Returns an element. @pre index < count()
  [[nodiscard]] PathElement element(std::uint32_t index) const;

  /// Returns the total angle in radians, positive, including the whole turns.
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
  float partial_turn_ = 0.0F;  ///< Angle in radians, in (0, 2π], without the whole turns.
  float sweep_ = 0.0F;
  std::uint32_t count_ = 1;
};

}  // namespace cnc
