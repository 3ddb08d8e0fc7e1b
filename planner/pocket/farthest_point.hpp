#pragma once

#include "planner/pocket/nearest_curve.hpp"

namespace cnc::pocket {

/// Finds the greatest distance between the boundary of an area and an inward offset of the same
/// area.
///
/// Each element of the boundary is halved until an upper bound shows that no point of a part is
/// farther from the goal than the farthest point found. Along a line or an arc, the distance from
/// one point is greatest at an end or at a maximum between the ends. The tangents of an arc show
/// whether there is such a maximum; then the bound includes the height of the arc. If the offset of
/// a part is on the boundary of the goal, the distance of the part is that of the offset.
///
/// Guarantee: the result is at most kFarthestError less than the greatest distance. Time: (n + m)
/// log n for n elements of the goal and m halvings, a few for each corner.
inline constexpr double kFarthestError = 1.0e-9;  // Greatest error of the result, mm.
template <typename Scalar>
class FarthestPoint {
 public:
  /// @param goal  boundary of the area after it was moved inwards
  /// @param moved  distance by which it was moved, mm
  FarthestPoint(const NearestCurve<Scalar>& goal, Scalar moved) : goal_{goal}, moved_{moved} {}

  /// Returns the greatest distance between the boundary of `area` and the goal. @pre the goal has
  /// an element
  [[nodiscard]] Scalar of(const contour::ContourView<Scalar>& area);

 private:
  using Vector = BasicVec2<Scalar>;

  /// A part of an element, with the points of the goal that are nearest to its ends.
  struct Stretch {
    Vector from{Scalar{0}, Scalar{0}};
    Vector to{Scalar{0}, Scalar{0}};
    NearestPoint<Scalar> at_from;
    NearestPoint<Scalar> at_to;
  };

  [[nodiscard]] NearestPoint<Scalar> look(const Vector& place, std::uint32_t guess);
  void search(const contour::Curve<Scalar>& wall, const Stretch& whole);
  [[nodiscard]] Scalar bound(const contour::Curve<Scalar>& wall, const Stretch& stretch) const;
  [[nodiscard]] Scalar bound_from(const contour::Curve<Scalar>& wall,
                                  const Stretch& stretch,
                                  const Vector& point) const;
  [[nodiscard]] bool is_moved(const contour::Curve<Scalar>& wall,
                              const Stretch& stretch,
                              std::uint32_t curve) const;
  [[nodiscard]] bool find_moved(const contour::Curve<Scalar>& wall, std::uint32_t& near) const;

  const NearestCurve<Scalar>& goal_;
  Scalar moved_;
  Scalar farthest_{};
};

}  // namespace cnc::pocket
