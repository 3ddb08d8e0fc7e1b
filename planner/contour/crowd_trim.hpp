#pragma once

#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// Shortens raw curves by the parts that nearby corners of the same contour show to be too near to
/// it. That matters where a contour has many elements within the distance, as traced and scanned
/// contours do. Without the trim, each of their raw curves would cross most of the others. The
/// number of meetings would grow with the square of the number of elements within the distance. No
/// part that is removed belongs to a result. The parts that are left may still be too near.
template <typename Scalar>
class CrowdTrim {
 public:
  /// @param elements all elements of one loop, in order
  CrowdTrim(Slice<Curve<Scalar>> elements, Scalar distance, const Tolerance<Scalar>& tolerance)
      : elements_{elements},
        distance_{std::abs(distance)},
        radius_{distance_ - Scalar{4} * tolerance.shallow},
        touch_{tolerance.touch} {}

  /// Shortens a moved element, or the round join after it, to the one piece that is left of it.
  /// @param element number of the element in the loop
  /// @return false where nothing is left
  [[nodiscard]] bool keeps(Curve<Scalar>& raw, std::uint32_t element) const;

 private:
  using Vector = BasicVec2<Scalar>;

  [[nodiscard]] bool is_crowded(std::uint32_t element) const;
  [[nodiscard]] bool covers(const Vector& corner, const Vector& place) const;
  [[nodiscard]] bool trim(Curve<Scalar>& raw, const Vector& corner, bool& shortened) const;
  [[nodiscard]] Vector edge_of_line(const Curve<Scalar>& raw,
                                    const Vector& corner,
                                    bool from_start) const;
  [[nodiscard]] Vector edge_of_arc(const Curve<Scalar>& raw,
                                   const Vector& corner,
                                   bool from_start) const;

  Slice<Curve<Scalar>> elements_;
  Scalar distance_;
  Scalar radius_;  ///< A point nearer to a corner than this is certainly too near.
  Scalar touch_;
};

}  // namespace cnc::contour
