#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/import/curve.hpp"

namespace sim::drawing {

/// Converts the path commands of SVG to subpaths, in the units of the element.
class SvgPen {
 public:
  void move_to(const Place& place);
  void line_to(const Place& place);
  void cubic_to(const Place& first, const Place& second, const Place& place);
  void quadratic_to(const Place& control, const Place& place);
  /// Draws an elliptical arc to `place`, by SVG 1.1, F.6. A radius of 0 results in a line. Radii
  /// that are too small are enlarged.
  void arc_to(Place radii, double rotation_deg, bool large, bool positive, const Place& place);
  void close();
  void add(const Shape& shape) { shapes().push_back(shape); }

  [[nodiscard]] const Place& at() const { return at_; }
  [[nodiscard]] std::size_t shape_count() const { return count_; }
  [[nodiscard]] std::vector<std::vector<Shape>>& subpaths() { return subpaths_; }

 private:
  std::vector<Shape>& shapes();

  std::vector<std::vector<Shape>> subpaths_;
  Place at_{0.0, 0.0};
  Place start_{0.0, 0.0};
  std::size_t count_ = 0;
  bool open_ = false;
};

/// Draws the attribute `d` of a path. Returns an empty text, or an error with the number of the
/// character at which it is.
[[nodiscard]] std::string draw_path(std::string_view data, SvgPen& pen);

/// Draws the attribute `points` of a polyline or polygon. Returns an empty text, or an error.
[[nodiscard]] std::string draw_points(std::string_view points, bool closed, SvgPen& pen);

}  // namespace sim::drawing
