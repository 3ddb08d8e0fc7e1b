#pragma once

#include <cstdint>
#include <vector>

#include "planner/pocket/area_distance.hpp"

namespace sim::pocket {

/// What a cell of a Voronoi diagram belongs to: an element, or a corner between two.
struct BoundarySite {
  std::uint32_t element = 0;
  std::uint32_t other = 0;  ///< The other element at a corner; else the same.

  [[nodiscard]] bool is_corner() const { return element != other; }
  [[nodiscard]] bool has(std::uint32_t index) const { return element == index || other == index; }
};

/// Rows of elements of a boundary that join smoothly and along which the curvature only grows, or
/// only falls. Circles of curvature lie within each other along such a row (Kneser), so that no
/// disc in the area touches two of its places, unless one of them is a corner at its end.
class SmoothRows {
 public:
  explicit SmoothRows(const cnc::pocket::AreaDistance& area);

  /// Whether the boundary goes smoothly on where an element begins.
  [[nodiscard]] bool begins_smoothly(std::uint32_t element) const { return is_smooth_[element]; }

  /// Whether a disc in the area may touch both.
  [[nodiscard]] bool may_share_disc(const BoundarySite& a, const BoundarySite& b) const;

 private:
  static std::vector<std::uint32_t> numbered(const cnc::pocket::AreaDistance& area, double sign);

  std::vector<bool> is_smooth_;         ///< The joint at the start of each element.
  std::vector<std::uint32_t> growing_;  ///< The row of each element.
  std::vector<std::uint32_t> falling_;
};

}  // namespace sim::pocket
