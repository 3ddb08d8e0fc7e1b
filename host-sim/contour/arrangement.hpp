#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host-sim/contour/arranged_edge.hpp"
#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/contour/owned_offset_space.hpp"

namespace sim {

/// The division of the plane into faces by closed loops of lines and arcs, with the winding number
/// of each loop around each face. The elements are divided by the code that cuts raw curves for an
/// offset.
///
/// Time: n log n for n elements if each of them meets only few others. Each row of edges between
/// points where loops meet adds a time proportional to the number of elements on the line of its
/// ray (see WindingRays).
class Arrangement {
 public:
  /// Divides the plane by loops. Points closer to each other than `touch_mm`, or than the
  /// resolution of coordinates of this size, count as one point.
  /// @return false if there are more meetings than kMaxMeetings, or numbers that are not finite
  [[nodiscard]] bool divide(const cnc::contour::ContourView<double>& loops, double touch_mm);

  [[nodiscard]] const std::vector<ArrangedEdge>& edges() const { return edges_; }
  [[nodiscard]] std::span<const EdgeOwner> owners(const ArrangedEdge& edge) const {
    return std::span{owners_}.subspan(edge.first_owner, edge.end_owner - edge.first_owner);
  }
  [[nodiscard]] const Windings& windings(std::uint32_t number) const { return windings_[number]; }

  [[nodiscard]] const cnc::WideVec2& place(std::uint32_t node) const { return nodes_[node].place; }
  /// Returns the point halfway along an edge.
  [[nodiscard]] cnc::WideVec2 middle(const ArrangedEdge& edge) const;
  /// Returns the length of an edge, mm.
  [[nodiscard]] double length_mm(const ArrangedEdge& edge) const;

  /// Joins edges to loops whose inside is on their left. The loops may touch each other and
  /// themselves, but never cross.
  /// @return false if rounding keeps edges from leading back to their start
  [[nodiscard]] bool write_loops(std::span<const DirectedEdge> kept, Contour& out);

 private:
  static constexpr std::size_t kMaxMeetings = 8'000'000;

  void add_elements(const cnc::contour::ContourView<double>& loops);
  void add_loop(const cnc::contour::ContourView<double>& loops, std::size_t loop);
  void add_element(const cnc::WideVec2& from, const cnc::WideVec2& to, double bulge);
  [[nodiscard]] bool cut(const std::vector<cnc::contour::RawCurve<double>>& curves);
  [[nodiscard]] std::vector<cnc::contour::RawCurve<double>> parts_of_pieces(
      const std::vector<cnc::contour::RawCurve<double>>& curves) const;
  void make_edges();
  void add_edges(std::vector<std::uint32_t>& pieces);
  void add_edge(std::span<const std::uint32_t> pieces);
  [[nodiscard]] bool coincide(const cnc::contour::Piece& a, const cnc::contour::Piece& b) const;

  OwnedOffsetSpace space_;
  cnc::contour::Tolerance<double> tolerance_{};
  std::vector<cnc::contour::RawCurve<double>> raw_;
  std::vector<std::uint32_t> loop_of_raw_;
  std::vector<cnc::contour::Node<double>> nodes_;
  std::vector<cnc::contour::Piece> pieces_;
  std::vector<cnc::contour::Junction> junctions_;
  std::vector<ArrangedEdge> edges_;
  std::vector<EdgeOwner> owners_;
  std::vector<Windings> windings_;
};

}  // namespace sim
