#pragma once

#include "planner/contour/offset_space.hpp"

namespace cnc::contour {

/// Takes off raw curves what corners of the same contour nearby show to be too near to it, where a
/// contour has many elements within the distance, as traced and scanned ones do. Without
/// that each of their raw curves crosses most of the others, and meetings grow with the square of
/// how closely the contour is drawn. What is taken off is no part of any result; what is left may
/// still be too near.
template <typename Scalar>
class CrowdTrim {
 public:
  /// @param elements all of one loop, in order
  CrowdTrim(Slice<Curve<Scalar>> elements, Scalar distance, const Tolerance<Scalar>& tolerance)
      : elements_{elements},
        distance_{std::abs(distance)},
        radius_{distance_ - Scalar{4} * tolerance.shallow},
        touch_{tolerance.touch} {}

  /// Shortens a moved element, or the round join after it, and keeps one piece of it.
  /// @param element its number in the loop
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
  Scalar radius_;  ///< What is nearer to a corner is too near for certain.
  Scalar touch_;
};

}  // namespace cnc::contour
