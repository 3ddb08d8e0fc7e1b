#include "planner/geometry/arc_plane.hpp"

namespace cnc {
namespace {

bool holds(Plane plane, const AxisVector& vector) {
  const PlaneAxes axes = axes_of(plane);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (axis != axes.first && axis != axes.second && vector[axis] != 0.0F) return false;
  }
  return true;
}

}  // namespace

std::optional<PlaneFrame> plane_through(const AxisVector& first, const AxisVector& second) {
  constexpr float kMinAngle = 1.0e-4F;
  AxisVector across = sum_of(second, -dot(first, second), first);
  const float size = norm(across);
  if (size < kMinAngle) return std::nullopt;
  across = scaled(1.0F / size, across);
  // If the two vectors are nearly parallel, rounding has left a large part of `first` in `across`,
  // so this part is subtracted once more.
  across = sum_of(across, -dot(first, across), first);
  return PlaneFrame{first, scaled(1.0F / norm(across), across)};
}

std::optional<ArcPlane> plane_of(const AxisVector& first, const AxisVector& second) {
  for (const Plane plane : {Plane::kXY, Plane::kZX, Plane::kYZ}) {
    if (holds(plane, first) && holds(plane, second)) return ArcPlane{plane};
  }
  const auto frame = plane_through(first, second);
  if (!frame) return std::nullopt;
  return ArcPlane{*frame};
}

PlaneFrame ArcPlane::frame() const {
  if (oblique_) return frame_;
  PlaneFrame frame;
  const PlaneAxes axes = axes_of(plane_);
  frame.first[axes.first] = frame.second[axes.second] = 1.0F;
  return frame;
}

AxisVector ArcPlane::off(const AxisVector& vector) const {
  if (oblique_) {
    const Vec2 in_plane = seen(vector);
    return sum_of(sum_of(vector, -in_plane.x(), frame_.first), -in_plane.y(), frame_.second);
  }
  const PlaneAxes axes = axes_of(plane_);
  AxisVector off_plane = vector;
  off_plane[axes.first] = off_plane[axes.second] = 0.0F;
  return off_plane;
}

ArcPlane ArcPlane::holding(const AxisVector& chord) const {
  const float length = norm(chord);
  if (!oblique_ || length <= 0.0F) return *this;
  const AxisVector along = scaled(1.0F / length, chord);
  const auto frame = plane_through(along, vector(left_normal(seen(along))));
  return frame ? ArcPlane{*frame} : *this;
}

AxisVector ArcPlane::vector(const Vec2& seen) const {
  if (oblique_) return sum_of(scaled(seen.x(), frame_.first), seen.y(), frame_.second);
  const PlaneAxes axes = axes_of(plane_);
  AxisVector in_plane{};
  in_plane[axes.first] = seen.x();
  in_plane[axes.second] = seen.y();
  return in_plane;
}

}  // namespace cnc
