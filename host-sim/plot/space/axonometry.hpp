#pragma once

#include <Eigen/Core>

#include "host-sim/plot/view.hpp"

namespace sim {

/// The direction from the scene to the viewer of an axonometric picture. The viewer is infinitely
/// far away.
struct Viewpoint {
  double azimuth_deg = -60.0;   ///< Angle in the XY plane from the X axis, counter-clockwise.
  double elevation_deg = 35.0;  ///< Angle above the XY plane, more than 0 and less than 90.
};

/// A box in space, mm. It is empty until a point is included.
struct SpaceBox {
  Eigen::Vector3d least = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d most = Eigen::Vector3d::Constant(-std::numeric_limits<double>::infinity());

  void include(const Eigen::Vector3d& point) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  /// Returns a corner of the box. Bits 0, 1 and 2 of its number are set if the corner is at the
  /// greater end of X, Y and Z.
  [[nodiscard]] Eigen::Vector3d corner(unsigned number) const {
    return {(number & 1U) != 0 ? most.x() : least.x(),
            (number & 2U) != 0 ? most.y() : least.y(),
            (number & 4U) != 0 ? most.z() : least.z()};
  }
};

/// A point of a picture with its distance from the viewer, which is meant only for comparisons.
struct SeenPoint {
  double x_px = 0.0;
  double y_px = 0.0;
  /// Distance in the scale of the picture, which increases away from the viewer.
  double depth_px = 0.0;
};

/// Maps points in space to a picture, by a parallel projection at right angles to the picture.
class Axonometry {
 public:
  /// Fits a box in space into a box of the picture.
  /// @param stretch factor by which all heights are multiplied, above 0
  /// @pre the box is not a point
  Axonometry(const Viewpoint& viewpoint, const SpaceBox& space, double stretch, const Box& picture);

  [[nodiscard]] SeenPoint seen(const Eigen::Vector3d& point) const;
  /// Returns the part of the picture that the box in space covers.
  [[nodiscard]] const Extent& extent_px() const { return extent_px_; }
  /// Returns the components of a unit vector along the directions of the viewer: to the right,
  /// upwards, and towards the viewer.
  [[nodiscard]] Eigen::Vector3d turned(const Eigen::Vector3d& normal) const;
  [[nodiscard]] double px_per_mm() const { return px_per_mm_; }

 private:
  Eigen::Vector3d right_;
  Eigen::Vector3d up_;
  Eigen::Vector3d towards_;
  double stretch_;
  double px_per_mm_ = 1.0;
  double left_px_ = 0.0;
  double top_px_ = 0.0;
  Extent extent_px_;
};

}  // namespace sim
