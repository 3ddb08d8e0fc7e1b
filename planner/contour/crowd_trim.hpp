#pragma once

#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// Removes the parts of raw curves that are too near to nearby corners of the same contour. This
/// matters if many elements of a contour are within the offset distance of each other, as in traced
/// and scanned contours. Without the trim, each of their raw curves would cross most of the others.
/// The number of meetings would grow with the square of the number of these elements. No removed
/// part belongs to a result. The remaining parts may still be too near.
template <typename Scalar>
class CrowdTrim {
 public:
  /// @param elements all elements of one loop, in order
  CrowdTrim(Slice<Curve<Scalar>> elements, Scalar distance, const Tolerance<Scalar>& tolerance)
      : elements_{elements},
        distance_{std::abs(distance)},
        radius_{distance_ - Scalar{4} * tolerance.shallow},
        touch_{tolerance.touch} {}

  /// Shortens a moved element, or the round join after it, to the one part that remains.
  /// @param element number of the element in the loop
  /// @return false if nothing remains
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
  /// Radius of the disc about a corner, mm. A point in the disc is certainly too near.
  Scalar radius_;
  Scalar touch_;
};

}  // namespace cnc::contour
