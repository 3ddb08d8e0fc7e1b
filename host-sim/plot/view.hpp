#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "host-sim/plot/path.hpp"

namespace sim {

/// A rectangle in machine coordinates, with sides along the axes. It is empty until a point is
/// included.
struct Extent {
  double left_mm = std::numeric_limits<double>::infinity();
  double right_mm = -std::numeric_limits<double>::infinity();
  double bottom_mm = std::numeric_limits<double>::infinity();
  double top_mm = -std::numeric_limits<double>::infinity();

  void include(double x_mm, double y_mm) {
    left_mm = std::min(left_mm, x_mm);
    right_mm = std::max(right_mm, x_mm);
    bottom_mm = std::min(bottom_mm, y_mm);
    top_mm = std::max(top_mm, y_mm);
  }
  [[nodiscard]] bool is_empty() const { return right_mm < left_mm; }
  [[nodiscard]] double width_mm() const { return is_empty() ? 0.0 : right_mm - left_mm; }
  [[nodiscard]] double height_mm() const { return is_empty() ? 0.0 : top_mm - bottom_mm; }
};

/// A rectangle in a picture, whose y points downwards.
struct Box {
  double left_px;
  double top_px;
  double width_px;
  double height_px;
  [[nodiscard]] double right_px() const { return left_px + width_px; }
  [[nodiscard]] double bottom_px() const { return top_px + height_px; }
};

/// Maps machine coordinates, whose y points upwards, to a picture. The mapped area is as large as a
/// box of the picture allows, and is in its middle.
class View {
 public:
  /// @pre `bounds` has a width and a height
  View(const Extent& bounds, const Box& box)
      : box_{box},
        px_per_mm_{std::min(box.width_px / bounds.width_mm(), box.height_px / bounds.height_mm())},
        middle_x_mm_{0.5 * (bounds.left_mm + bounds.right_mm)},
        middle_y_mm_{0.5 * (bounds.bottom_mm + bounds.top_mm)} {}

  [[nodiscard]] const Box& box() const { return box_; }
  [[nodiscard]] double px_per_mm() const { return px_per_mm_; }
  [[nodiscard]] double x_px(double x_mm) const {
    return box_.left_px + 0.5 * box_.width_px + (x_mm - middle_x_mm_) * px_per_mm_;
  }
  [[nodiscard]] double y_px(double y_mm) const {
    return box_.top_px + 0.5 * box_.height_px - (y_mm - middle_y_mm_) * px_per_mm_;
  }
  [[nodiscard]] double x_mm(double x_px) const {
    return middle_x_mm_ + (x_px - box_.left_px - 0.5 * box_.width_px) / px_per_mm_;
  }
  [[nodiscard]] double y_mm(double y_px) const {
    return middle_y_mm_ - (y_px - box_.top_px - 0.5 * box_.height_px) / px_per_mm_;
  }

 private:
  Box box_;
  double px_per_mm_;
  double middle_x_mm_;
  double middle_y_mm_;
};

/// Returns the smallest number of the form 1, 2 or 5 times a power of ten that is at least `least`
/// (> 0).
[[nodiscard]] inline double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

/// Returns the extent of those stretches of a path whose `move` is `least` or a later value in the
/// enumeration Move.
[[nodiscard]] inline Extent bounds_of(const std::vector<PathVertex>& vertices, Move least) {
  Extent bounds;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (vertices[i].move < least) continue;
    const PathVertex& from = vertices[i == 0 ? 0 : i - 1];
    bounds.include(from.x_mm, from.y_mm);
    bounds.include(vertices[i].x_mm, vertices[i].y_mm);
  }
  return bounds;
}

}  // namespace sim
