#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host-sim/contour/arranged_edge.hpp"
#include "planner/contour/offset_space.hpp"

namespace sim {

/// Computes the winding number of each loop on both sides of each edge. The edges between two
/// points where loops meet form a row, and a ray is cast from one edge of each row. A piece on top
/// of the edge from which the ray is cast counts by the direction of the piece. Whether the ray
/// crosses any other piece follows from the sides of its chord and of its circle on which the ray
/// begins.
class WindingRays {
 public:
  /// Creates an object that refers to its arguments, which must outlive it.
  /// @param pieces pieces whose member `next` is the number of their edge
  WindingRays(std::vector<ArrangedEdge>& edges,
              std::span<const EdgeOwner> owners,
              std::span<const cnc::contour::Piece> pieces,
              std::span<const cnc::contour::RawCurve<double>> raw,
              std::span<const std::uint32_t> loop_of_raw,
              std::span<const cnc::contour::Node<double>> nodes);

  /// Returns the list of windings, and sets `left` and `right` of each edge to indices of this
  /// list.
  [[nodiscard]] std::vector<Windings> find_all();

 private:
  void index_pieces();
  void link_edges();
  void find(std::uint32_t number);
  void follow(std::uint32_t number, bool forwards);
  [[nodiscard]] Windings turns_beside(std::uint32_t edge, const cnc::WideVec2& from, bool upwards);
  [[nodiscard]] int crossing(const cnc::contour::Piece& piece,
                             const cnc::WideVec2& from,
                             bool upwards) const;

  std::vector<ArrangedEdge>& edges_;
  std::span<const EdgeOwner> owners_;
  std::span<const cnc::contour::Piece> pieces_;
  std::span<const cnc::contour::RawCurve<double>> raw_;
  std::span<const std::uint32_t> loop_of_raw_;
  std::span<const cnc::contour::Node<double>> nodes_;
  std::vector<cnc::contour::FlatBox<double>> boxes_;
  cnc::contour::BoxTree<double> tree_;
  std::vector<std::uint32_t> degree_;  ///< Number of edges at each node.
  /// Numbers of the edges at each node; only the first two if there are more.
  std::vector<std::array<std::uint32_t, 2>> ends_;
  std::vector<Windings> windings_;
};

}  // namespace sim
