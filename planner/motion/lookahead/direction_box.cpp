#include "planner/motion/lookahead/direction_box.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::motion {
namespace {

constexpr float kNoLength = 1.0e12F;  // Greater than the length of any vector.

}  // namespace

DirectionBox::DirectionBox(float first, float last, const ArcAxes& axes)
    : middle_{sin_cos(0.5F * (first + last))},
      half_{sin_cos(std::min(0.5F * (last - first), kHalfPi))},
      axes_{axes} {}

bool DirectionBox::holds(float tangent, float normal) const {
  const float length_square = square(tangent) + square(normal);
  for (const ArcAxis& axis : axes_) {
    const float along = axis.in_plane.share(middle_);
    const float across = axis.in_plane.normal_share(middle_);
    const float own = std::abs(tangent * along + normal * across);
    const float other = std::abs(tangent * across - normal * along);
    const float size_square = square(axis.in_plane.size) * length_square;
    const bool anywhere = size_square <= square(axis.acceleration);
    if (!anywhere && turned(own, other) > axis.acceleration) return false;
  }
  return true;
}

float DirectionBox::max_along() const {
  float most = kNoLength;
  for (const ArcAxis& axis : axes_) {
    const float own = std::abs(axis.in_plane.share(middle_));
    const float other = std::abs(axis.in_plane.normal_share(middle_));
    most = std::min(most, axis.acceleration / std::min(axis.in_plane.size, turned(own, other)));
  }
  return most;
}

/// Returns the greatest component along an axis that a vector has when it is turned towards the
/// axis by up to half of the range's angle. If this turn can make the vector parallel to the axis,
/// returns kNoLength, which exceeds the length of any vector.
/// @param own, other components of the vector along the axis and across it
float DirectionBox::turned(float own, float other) const {
  const bool beside = other * half_.cosine > own * half_.sine;
  return beside ? own * half_.cosine + other * half_.sine : kNoLength;
}

}  // namespace cnc::motion
