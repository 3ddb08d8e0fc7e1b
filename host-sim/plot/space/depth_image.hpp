#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "host-sim/plot/pixel_image.hpp"
#include "host-sim/plot/space/axonometry.hpp"

namespace sim {

/// A corner of a triangle in a picture: its point and its colour, whose red, green and blue are
/// from 0 to 1.
struct ShadedCorner {
  SeenPoint place;
  Eigen::Vector3f colour = Eigen::Vector3f::Zero();
};

/// An image of triangles with a depth buffer. Each pixel shows the triangle that is nearest to the
/// viewer.
class DepthImage {
 public:
  /// @param box part of the picture that the image covers
  /// @param scale number of pixels of the image per pixel of the picture
  DepthImage(const Box& box, double scale);

  /// Draws a triangle, except where a nearer triangle was drawn.
  void draw(const std::array<ShadedCorner, 3>& corners);
  /// Returns whether a point is visible: no triangle is nearer to the viewer by more than
  /// `slack_px`. Because edges are between pixels, one pixel at or around the point that shows no
  /// such triangle is sufficient. A point outside of the image is visible.
  [[nodiscard]] bool shows(const SeenPoint& point, double slack_px) const;

  [[nodiscard]] const PixelImage& image() const { return image_; }
  [[nodiscard]] const Box& box() const { return box_; }

 private:
  [[nodiscard]] SeenPoint in_image(const SeenPoint& point) const;
  [[nodiscard]] float& depth(int column, int row) {
    return depths_[static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width()) +
                   static_cast<std::size_t>(column)];
  }

  Box box_;
  double scale_;
  PixelImage image_;
  std::vector<float> depths_;
};

}  // namespace sim
