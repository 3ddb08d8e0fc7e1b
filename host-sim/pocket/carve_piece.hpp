#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/pocket/medial_axis.hpp"

namespace sim::pocket {

/// A stretch of the axis that a tool follows without interruption.
struct CarvePiece {
  std::uint32_t from = 0;  ///< Number of the first node.
  std::uint32_t to = 0;    ///< Number of the last node.
  std::vector<AxisPoint>
      points;  ///< At least two. With a V tool, their radii are those of its cut at the top.
};

/// The part of an axis that is cut, as pieces between nodes.
struct CarveGraph {
  std::vector<AxisPoint> nodes;
  std::vector<CarvePiece> pieces;
};

/// Returns the part of the axis whose radius is at most `greatest_radius_mm`. Where a chain leaves
/// that part, it is cut at a new node.
[[nodiscard]] CarveGraph narrow_part(const MedialAxis& axis,
                                     const OwnedArea& area,
                                     double greatest_radius_mm);

/// Returns the part of the axis whose radius is at least `min_radius_mm`. Where a chain leaves
/// that part, it is cut at a new node. Nodes of the axis with a smaller radius are kept, without
/// pieces.
[[nodiscard]] CarveGraph wide_part(const MedialAxis& axis,
                                   const OwnedArea& area,
                                   double min_radius_mm);

/// Reduces the points of all pieces. Reduces radii where a straight line between points would let
/// the tool cut into the wall: near a corner that points into the area, the distance from the
/// boundary is less than its linear interpolation.
///
/// Lines are within half of `tolerance_mm` of the axis in the plane. Their radii are at most those
/// that fit into the area, and less by at most the tolerance. Each stretch between kept points is
/// the longest that is possible from the end of the previous stretch.
void fit_lines(CarveGraph& graph, const OwnedArea& area, double tolerance_mm);

}  // namespace sim::pocket
