#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// An edge in the border of a piece.
struct BorderEdge {
  std::uint32_t edge = 0;
  bool is_reversed = false;  ///< Whether the border passes the edge from its end to its start.
};

/// Pieces of a surface and the edges between them. If a large piece shares a border with several
/// small pieces, the border is divided at the corners of the small pieces. An edge thus has at most
/// one piece on each side, and both pieces use the same control points. All edges at a corner end
/// in exactly the same point. So a result that is computed only from an edge is the same for both
/// pieces.
class PieceNet {
 public:
  /// @pre pieces do not overlap, and adjacent pieces have equal parameters at their common border
  explicit PieceNet(std::vector<GridPatch> pieces);

  [[nodiscard]] const std::vector<GridPatch>& pieces() const { return pieces_; }
  [[nodiscard]] const std::vector<BezierCurve>& edges() const { return edges_; }
  /// Returns the edges around a piece in order.
  [[nodiscard]] std::span<const BorderEdge> border(std::size_t piece) const {
    return std::span{borders_}.subspan(first_edge_[piece],
                                       first_edge_[piece + 1] - first_edge_[piece]);
  }

 private:
  class Builder;

  std::vector<GridPatch> pieces_;
  std::vector<BezierCurve> edges_;
  std::vector<BorderEdge> borders_;  ///< Edges around all pieces, piece by piece.
  /// Index in borders_ of the first edge of each piece. The last entry is the size of borders_.
  std::vector<std::size_t> first_edge_;
};

}  // namespace sim::surface::patch
