#pragma once

#include <cstdint>
#include <vector>

#include "planner/pocket/area_distance.hpp"

namespace sim::pocket {

/// The part of a boundary to which a cell of a Voronoi diagram belongs: an element, or a corner
/// between two elements.
struct BoundarySite {
  std::uint32_t element = 0;
  std::uint32_t other = 0;  ///< At a corner the second element; else equal to `element`.

  [[nodiscard]] bool is_corner() const { return element != other; }
  [[nodiscard]] bool has(std::uint32_t index) const { return element == index || other == index; }
};

/// Rows of elements of a boundary that join smoothly and along which the curvature only grows, or
/// only falls. Along such a row, the circles of curvature lie within each other (Kneser). So no
/// disc in the area touches two of its points, unless one of them is a corner at its end.
class SmoothRows {
 public:
  explicit SmoothRows(const cnc::pocket::AreaDistance& area);

  /// Returns whether the boundary continues smoothly at the beginning of an element.
  [[nodiscard]] bool begins_smoothly(std::uint32_t element) const { return is_smooth_[element]; }

  /// Returns whether a disc in the area may touch both sites.
  [[nodiscard]] bool may_share_disc(const BoundarySite& a, const BoundarySite& b) const;

 private:
  static std::vector<std::uint32_t> numbered(const cnc::pocket::AreaDistance& area, double sign);

  /// For each element, whether the joint at its start is smooth.
  std::vector<bool> is_smooth_;
  std::vector<std::uint32_t> growing_;  ///< For each element, its row of growing curvature.
  std::vector<std::uint32_t> falling_;
};

}  // namespace sim::pocket
