#pragma once

#include <cstdint>
#include <vector>

#include "planner/pocket/area_distance.hpp"

namespace sim::pocket {

/// The part of a boundary that generates a cell of a Voronoi diagram: an element, or a corner
/// between two elements.
struct BoundarySite {
  std::uint32_t element = 0;
  std::uint32_t other = 0;  ///< Second element of a corner; otherwise equal to `element`.

  [[nodiscard]] bool is_corner() const { return element != other; }
  [[nodiscard]] bool has(std::uint32_t index) const { return element == index || other == index; }
};

/// Rows of elements of a boundary that join smoothly, and along which the curvature only grows or
/// only falls. The osculating circles along such a row lie within each other (Kneser). Therefore no
/// disc in the area touches two points of the row, unless one of the points is a corner at the
/// row's end.
class SmoothRows {
 public:
  explicit SmoothRows(const cnc::pocket::AreaDistance& area);

  /// Returns whether the boundary is smooth at the beginning of an element.
  [[nodiscard]] bool begins_smoothly(std::uint32_t element) const { return is_smooth_[element]; }

  /// Returns whether a disc in the area may touch both sites.
  [[nodiscard]] bool may_share_disc(const BoundarySite& a, const BoundarySite& b) const;

 private:
  static std::vector<std::uint32_t> numbered(const cnc::pocket::AreaDistance& area, double sign);

  /// For each element, whether the joint at its start is smooth.
  std::vector<bool> is_smooth_;
  /// For each element, the number of its row of growing curvature.
  std::vector<std::uint32_t> growing_;
  std::vector<std::uint32_t> falling_;
};

}  // namespace sim::pocket
