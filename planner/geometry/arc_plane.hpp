#pragma once

#include <optional>

#include "planner/base/axis_vector.hpp"
#include "planner/base/contract.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {

/// Two perpendicular unit vectors that span a plane.
struct PlaneFrame {
  AxisVector first{};
  AxisVector second{};
  constexpr bool operator==(const PlaneFrame&) const = default;
};

/// Returns the plane of two unit vectors. The plane's first vector is along `first`, and `second`
/// is to the left of `first`. The result is empty if the two vectors are within 1e-4 rad of one
/// line, because many planes contain that line.
[[nodiscard]] std::optional<PlaneFrame> plane_through(const AxisVector& first,
                                                      const AxisVector& second);

/// The plane in which an arc turns: a coordinate plane, or an oblique plane that any two vectors in
/// the space of all axes span. Arcs turn counter-clockwise from the first vector to the second.
class ArcPlane {
 public:
  constexpr ArcPlane() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): each coordinate plane is an ArcPlane.
  constexpr ArcPlane(Plane plane) : plane_{plane} {}
  constexpr explicit ArcPlane(const PlaneFrame& frame) : oblique_{true}, frame_{frame} {}

  [[nodiscard]] constexpr bool oblique() const { return oblique_; }
  /// Returns the coordinate plane. @pre !oblique()
  [[nodiscard]] constexpr Plane coordinate_plane() const {
    CNC_ASSERT(!oblique_);
    return plane_;
  }
  [[nodiscard]] PlaneFrame frame() const;
  /// Returns whether a motion in the plane may move an axis.
  [[nodiscard]] constexpr bool has(std::size_t axis) const {
    if (oblique_) return frame_.first[axis] != 0.0F || frame_.second[axis] != 0.0F;
    const PlaneAxes axes = axes_of(plane_);
    return axis == axes.first || axis == axes.second;
  }

  /// Returns the projection of a vector onto the plane, in coordinates of the plane.
  [[nodiscard]] Vec2 seen(const AxisVector& vector) const {
    if (oblique_) return {dot(vector, frame_.first), dot(vector, frame_.second)};
    const PlaneAxes axes = axes_of(plane_);
    return {vector[axes.first], vector[axes.second]};
  }
  [[nodiscard]] Vec2 seen(const Position& from, const Position& to) const {
    if (oblique_) return seen(travel_between(from, to));
    const PlaneAxes axes = axes_of(plane_);
    return {(to[axes.first] - from[axes.first]).mm(), (to[axes.second] - from[axes.second]).mm()};
  }
  /// Returns the component of a vector perpendicular to the plane.
  [[nodiscard]] AxisVector off(const AxisVector& vector) const;
  /// Returns the vector that has the given coordinates in the plane.
  [[nodiscard]] AxisVector vector(const Vec2& seen) const;
  /// Returns an oblique plane tilted so that it contains `chord`. A coordinate plane is returned
  /// unchanged.
  [[nodiscard]] ArcPlane holding(const AxisVector& chord) const;

  constexpr bool operator==(const ArcPlane&) const = default;

 private:
  Plane plane_ = Plane::kXY;
  bool oblique_ = false;
  PlaneFrame frame_{};  ///< Vectors that span an oblique plane.
};

/// Returns the plane of two unit vectors: a coordinate plane if one contains both exactly,
/// otherwise plane_through() of the two vectors.
[[nodiscard]] std::optional<ArcPlane> plane_of(const AxisVector& first, const AxisVector& second);

/// Returns the axes of a coordinate plane. @pre `plane` is a coordinate plane
[[nodiscard]] constexpr PlaneAxes axes_of(const ArcPlane& plane) {
  return axes_of(plane.coordinate_plane());
}

}  // namespace cnc
