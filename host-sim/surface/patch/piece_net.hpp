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
  bool is_reversed = false;  ///< The border runs along it from its end to its start.
};

/// Pieces of a surface and the edges between them. A border that a large piece shares with several
/// small ones is divided where they meet, so that an edge has one piece at each side, and both
/// sides see the same control points to the last bit. All edges that meet in a point have the same
/// end there. A result that is computed from an edge alone is thus the same for both of its pieces.
class PieceNet {
 public:
  /// @pre pieces do not overlap, and those that meet have equal parameters there
  explicit PieceNet(std::vector<GridPatch> pieces);

  [[nodiscard]] const std::vector<GridPatch>& pieces() const { return pieces_; }
  [[nodiscard]] const std::vector<BezierCurve>& edges() const { return edges_; }
  /// Returns the edges around a piece, one behind the other.
  [[nodiscard]] std::span<const BorderEdge> border(std::size_t piece) const {
    return std::span{borders_}.subspan(first_edge_[piece],
                                       first_edge_[piece + 1] - first_edge_[piece]);
  }

 private:
  class Builder;

  std::vector<GridPatch> pieces_;
  std::vector<BezierCurve> edges_;
  std::vector<BorderEdge> borders_;      ///< Piece by piece.
  std::vector<std::size_t> first_edge_;  ///< Indices of borders_; one more than pieces.
};

}  // namespace sim::surface::patch
