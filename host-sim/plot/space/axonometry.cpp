#include "host-sim/plot/space/axonometry.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace sim {

Axonometry::Axonometry(const Viewpoint& viewpoint,
                       const SpaceBox& space,
                       double stretch,
                       const Box& picture)
    : stretch_{stretch} {
  const double azimuth = viewpoint.azimuth_deg * std::numbers::pi / 180.0;
  const double elevation = viewpoint.elevation_deg * std::numbers::pi / 180.0;
  towards_ = {std::cos(elevation) * std::cos(azimuth),
              std::cos(elevation) * std::sin(azimuth),
              std::sin(elevation)};
  right_ = {-std::sin(azimuth), std::cos(azimuth), 0.0};
  up_ = towards_.cross(right_);
  Extent seen_mm;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const SeenPoint point = seen(space.corner(corner));
    seen_mm.include(point.x_px, point.y_px);
  }
  px_per_mm_ =
      std::min(picture.width_px / seen_mm.width_mm(), picture.height_px / seen_mm.height_mm());
  left_px_ = picture.left_px + 0.5 * picture.width_px -
             0.5 * px_per_mm_ * (seen_mm.left_mm + seen_mm.right_mm);
  top_px_ = picture.top_px + 0.5 * picture.height_px -
            0.5 * px_per_mm_ * (seen_mm.bottom_mm + seen_mm.top_mm);
  for (unsigned corner = 0; corner < 8; ++corner) {
    const SeenPoint point = seen(space.corner(corner));
    extent_px_.include(point.x_px, point.y_px);
  }
}

SeenPoint Axonometry::seen(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d stretched{point.x(), point.y(), stretch_ * point.z()};
  return {left_px_ + px_per_mm_ * right_.dot(stretched),
          top_px_ - px_per_mm_ * up_.dot(stretched),
          -px_per_mm_ * towards_.dot(stretched)};
}

Eigen::Vector3d Axonometry::turned(const Eigen::Vector3d& normal) const {
  const Eigen::Vector3d stretched =
      Eigen::Vector3d{normal.x(), normal.y(), normal.z() / stretch_}.normalized();
  return {right_.dot(stretched), up_.dot(stretched), towards_.dot(stretched)};
}

}  // namespace sim
