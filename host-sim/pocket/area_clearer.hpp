#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/pocket/carve_piece.hpp"
#include "host-sim/pocket/crescent_driver.hpp"

namespace sim::pocket {

/// Clears all parts of an area that a tool reaches, one part after another. In each part, it clears
/// the pieces of the medial axis, beginning at the widest node.
class AreaClearer {
 public:
  /// @param graph the part of the axis along which the tool fits
  AreaClearer(const OwnedArea& area,
              const CarveGraph& graph,
              const AdaptiveOptions& options,
              CrescentDriver& driver);

  void clear();

 private:
  /// A node whose disc is cleared, with the discs that lead from it back to the previous node.
  struct Frame {
    std::uint32_t node = 0;
    cnc::pocket::ToolCircle circle;
    std::vector<cnc::pocket::ToolCircle> way_back;
  };

  [[nodiscard]] cnc::pocket::ToolCircle circle_of(std::uint32_t node) const;
  void clear_part(std::uint32_t start);
  [[nodiscard]] std::vector<AxisPoint> points_from(std::uint32_t node, std::size_t piece) const;
  [[nodiscard]] std::vector<cnc::WideVec2> way_from(std::uint32_t node) const;
  [[nodiscard]] std::optional<std::size_t> piece_left_at(std::uint32_t node) const;
  void clear_piece(std::size_t index, std::vector<Frame>& frames);
  void return_to(const cnc::pocket::ToolCircle& circle);

  const OwnedArea& area_;
  const CarveGraph& graph_;
  AdaptiveOptions options_;
  CrescentDriver& driver_;
  std::vector<std::vector<std::size_t>> at_node_;
  std::vector<bool> is_reached_;  ///< For each node, whether its disc is cleared.
  std::vector<bool> is_taken_;    ///< For each piece, whether it is cleared.
  /// Discs of the return that is still to be driven. After the last piece of a part, no return
  /// follows.
  std::vector<cnc::pocket::ToolCircle> way_back_;
};

/// Splits each piece that is wider in the middle than at both of its nodes: inserts a node at the
/// widest point.
void split_at_widest(CarveGraph& graph);

}  // namespace sim::pocket
