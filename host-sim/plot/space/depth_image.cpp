#include "host-sim/plot/space/depth_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {
namespace {

int pixels_for(double length_px, double scale) {
  return std::max(1, static_cast<int>(std::ceil(length_px * scale)));
}

std::uint8_t byte_of(float share) {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

/// Returns twice the signed area of the triangle from `a` to `b` to (x, y).
double twice_area(const SeenPoint& a, const SeenPoint& b, double x, double y) {
  return (b.x_px - a.x_px) * (y - a.y_px) - (b.y_px - a.y_px) * (x - a.x_px);
}

}  // namespace

DepthImage::DepthImage(const Box& box, double scale)
    : box_{box},
      scale_{scale},
      image_{pixels_for(box.width_px, scale), pixels_for(box.height_px, scale)},
      depths_(static_cast<std::size_t>(image_.width()) * static_cast<std::size_t>(image_.height()),
              std::numeric_limits<float>::infinity()) {}

SeenPoint DepthImage::in_image(const SeenPoint& point) const {
  return {
      (point.x_px - box_.left_px) * scale_, (point.y_px - box_.top_px) * scale_, point.depth_px};
}

void DepthImage::draw(const std::array<ShadedCorner, 3>& corners) {
  const std::array<SeenPoint, 3> places{
      in_image(corners[0].place), in_image(corners[1].place), in_image(corners[2].place)};
  const double area = twice_area(places[0], places[1], places[2].x_px, places[2].y_px);
  if (area == 0.0) return;
  const auto [left, right] = std::minmax({places[0].x_px, places[1].x_px, places[2].x_px});
  const auto [top, bottom] = std::minmax({places[0].y_px, places[1].y_px, places[2].y_px});
  const int first_row = std::max(0, static_cast<int>(std::floor(top)));
  const int last_row = std::min(image_.height() - 1, static_cast<int>(std::ceil(bottom)));
  const int first_column = std::max(0, static_cast<int>(std::floor(left)));
  const int last_column = std::min(image_.width() - 1, static_cast<int>(std::ceil(right)));
  // Least barycentric coordinate of a pixel that counts as part of a triangle. It is slightly below
  // 0, so that no pixel between neighbouring triangles is left out.
  constexpr double kSeam = -1.0e-9;
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const double x = column + 0.5;
      const double y = row + 0.5;
      const double c = twice_area(places[0], places[1], x, y) / area;
      const double a = twice_area(places[1], places[2], x, y) / area;
      const double b = 1.0 - a - c;
      if (a < kSeam || b < kSeam || c < kSeam) continue;
      const auto here = static_cast<float>(a * places[0].depth_px + b * places[1].depth_px +
                                           c * places[2].depth_px);
      if (here >= depth(column, row)) continue;
      depth(column, row) = here;
      const Eigen::Vector3f colour = static_cast<float>(a) * corners[0].colour +
                                     static_cast<float>(b) * corners[1].colour +
                                     static_cast<float>(c) * corners[2].colour;
      image_.set(column, row, {byte_of(colour.x()), byte_of(colour.y()), byte_of(colour.z())});
    }
  }
}

bool DepthImage::shows(const SeenPoint& point, double slack_px) const {
  const SeenPoint place = in_image(point);
  const int column = static_cast<int>(std::floor(place.x_px));
  const int row = static_cast<int>(std::floor(place.y_px));
  for (int y = std::max(0, row - 1); y <= std::min(image_.height() - 1, row + 1); ++y) {
    for (int x = std::max(0, column - 1); x <= std::min(image_.width() - 1, column + 1); ++x) {
      const float depth =
          depths_[static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width()) +
                  static_cast<std::size_t>(x)];
      if (static_cast<double>(depth) >= place.depth_px - slack_px) return true;
    }
  }
  return column < 0 || row < 0 || column >= image_.width() || row >= image_.height();
}

}  // namespace sim
