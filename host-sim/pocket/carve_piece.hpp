#pragma once

#include <cstdint>
#include <vector>

#include "host-sim/pocket/medial_axis.hpp"

namespace sim::pocket {

/// A stretch of the axis along which a tool goes at once.
struct CarvePiece {
  std::uint32_t from = 0;  ///< Node.
  std::uint32_t to = 0;    ///< Node.
  std::vector<AxisPoint>
      points;  ///< Two at least; a V tool's radii are those of its cut at the top.
};

/// The part of an axis that is cut: pieces between nodes.
struct CarveGraph {
  std::vector<AxisPoint> nodes;
  std::vector<CarvePiece> pieces;
};

/// Returns the axis as far as its radius is at most `greatest_radius_mm`. Where a chain goes beyond
/// that it is cut at a node of its own.
[[nodiscard]] CarveGraph narrow_part(const MedialAxis& axis,
                                     const OwnedArea& area,
                                     double greatest_radius_mm);

/// Returns the axis as far as its radius is at least `least_radius_mm`, in the same way. Nodes of
/// the axis whose radius is less stay, without pieces.
[[nodiscard]] CarveGraph wide_part(const MedialAxis& axis,
                                   const OwnedArea& area,
                                   double least_radius_mm);

/// Thins the points of all pieces out, and makes radii less where a straight line between points
/// would let the tool cut into the wall: by a corner that points into the area, distances from the
/// boundary grow less than in proportion.
///
/// Lines are within half of `tolerance_mm` of the axis in the plane, and their radii between those
/// that fit into the area and those less the tolerance. Each stretch between kept points is the
/// longest from where the one before it ends.
void fit_lines(CarveGraph& graph, const OwnedArea& area, double tolerance_mm);

}  // namespace sim::pocket
