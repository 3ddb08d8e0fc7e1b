#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host-sim/contour/arranged_edge.hpp"
#include "planner/contour/offset_space.hpp"

namespace sim {

/// Finds how often each loop runs around each side of each edge. Edges between points where loops
/// meet form a row, and one ray starts from one edge of each row. A piece on top of that edge
/// counts by its direction. Every other piece counts by the side of its chord and of its circle on
/// which the ray begins.
class WindingRays {
 public:
  /// Refers to its arguments, all of which must outlive this object.
  /// @param pieces `next` of each piece is the number of its edge
  WindingRays(std::vector<ArrangedEdge>& edges,
              std::span<const EdgeOwner> owners,
              std::span<const cnc::contour::Piece> pieces,
              std::span<const cnc::contour::RawCurve<double>> raw,
              std::span<const std::uint32_t> loop_of_raw,
              std::span<const cnc::contour::Node<double>> nodes);

  /// Returns the list of windings, and sets `left` and `right` of each edge to numbers of this
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
  /// The edges at each node; if there are more than two, the first two.
  std::vector<std::array<std::uint32_t, 2>> ends_;
  std::vector<Windings> windings_;
};

}  // namespace sim
