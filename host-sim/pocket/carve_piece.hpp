#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/pocket/medial_axis.hpp"

namespace sim::pocket {

/// A stretch of the medial axis that a tool follows without interruption.
struct CarvePiece {
  std::uint32_t from = 0;  ///< Number of the first node.
  std::uint32_t to = 0;    ///< Number of the last node.
  std::vector<AxisPoint>
      /// Points of the piece, at least two. For a V tool, the radius of a point is the radius of
      /// the cut at the top.
      points;
};

/// The part of a medial axis that is cut, as pieces between nodes.
struct CarveGraph {
  std::vector<AxisPoint> nodes;
  std::vector<CarvePiece> pieces;
};

/// Returns the part of the axis where the radius is at most `greatest_radius_mm`. Where a chain
/// leaves this part, the chain is cut at a new node.
[[nodiscard]] CarveGraph narrow_part(const MedialAxis& axis,
                                     const OwnedArea& area,
                                     double greatest_radius_mm);

/// Returns the part of the axis where the radius is at least `min_radius_mm`. Where a chain leaves
/// this part, the chain is cut at a new node. Nodes of the axis with a smaller radius are kept,
/// without pieces.
[[nodiscard]] CarveGraph wide_part(const MedialAxis& axis,
                                   const OwnedArea& area,
                                   double min_radius_mm);

/// Removes points of all pieces that straight lines can replace. Also reduces radii where a
/// straight line between two points would let the tool cut into the wall. This happens near a
/// corner that points into the area: there, the distance from the boundary is less than its linear
/// interpolation.
///
/// In the plane, lines are within a third of `tolerance_mm` of the axis. Their radii are at most
/// those that fit into the area, and smaller by at most `tolerance_mm`. Each stretch between kept
/// points is as long as possible from the end of the previous stretch.
void fit_lines(CarveGraph& graph, const OwnedArea& area, double tolerance_mm);

}  // namespace sim::pocket
