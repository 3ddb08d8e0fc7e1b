#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host-sim/surface/patch/patch_surface.hpp"

namespace sim::surface::patch {

/// An edge as a part of the border of a piece.
struct BorderEdge {
  std::uint32_t edge = 0;
  bool is_reversed = false;  ///< Whether the border runs along the edge from its end to its start.
};

/// Pieces of a surface and the edges between them. If a large piece shares a border with several
/// small ones, the border is divided where these meet. An edge thus has one piece at each side, and
/// both sides see the same control points to the last bit. All edges that meet in a point have the
/// same end there. A result that is computed from an edge alone is therefore the same for both of
/// its pieces.
class PieceNet {
 public:
  /// @pre pieces do not overlap, and pieces that meet have equal parameters there
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
  std::vector<BorderEdge> borders_;  ///< Edges around the pieces, piece by piece.
  /// For each piece the index of its first edge in borders_, and the number of edges at the end.
  std::vector<std::size_t> first_edge_;
};

}  // namespace sim::surface::patch
