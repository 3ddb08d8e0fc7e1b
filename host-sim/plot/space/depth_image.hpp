#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "host-sim/plot/pixel_image.hpp"
#include "host-sim/plot/space/axonometry.hpp"

namespace sim {

/// A corner of a triangle of a picture: its place and its colour, red, green and blue from 0 to 1.
struct ShadedCorner {
  SeenPoint place;
  Eigen::Vector3f colour = Eigen::Vector3f::Zero();
};

/// An image of triangles, each pixel of which shows the nearest one: a depth buffer.
class DepthImage {
 public:
  /// @param box the part of the picture; @param scale pixels of the image for one of the picture
  DepthImage(const Box& box, double scale);

  /// Draws a triangle where nothing nearer has been drawn.
  void draw(const std::array<ShadedCorner, 3>& corners);
  /// Returns whether no triangle lies more than `slack_px` nearer to the viewer than a point. One
  /// pixel around that shows the point, or nothing, is enough: edges lie between pixels.
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
