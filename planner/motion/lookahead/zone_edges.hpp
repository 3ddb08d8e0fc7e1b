#pragma once

#include <array>
#include <cstddef>

#include "planner/motion/block/block.hpp"
#include "planner/motion/lookahead/arc_grid.hpp"

namespace cnc::motion {

/// Edges of the zones that reach into a block. Each is a boundary between spans, besides those of
/// the arc's grid, and is kept as exact as it is: a zone of some nanometres must not become one of
/// a metre.
class ZoneEdges {
 public:
  static constexpr int kMost = 4;

  /// Adds the edges of all zones. @param length of the block in mm @pre there are none yet
  void add(const BlockZones& head, const BlockZones& tail, float length);
  /// Numbers the edges among the boundaries of the grid. An edge at one of these is left out.
  /// @pre not called before
  void number(const ArcShape& arc, const ArcGrid& grid);

  [[nodiscard]] int count() const { return count_; }
  /// Returns how many edges come before a boundary of the block. @pre number() was called
  [[nodiscard]] int before(int boundary) const {
    int before = 0;
    while (before < count_ && boundaries_[static_cast<std::size_t>(before)] < boundary) ++before;
    return before;
  }
  /// Checks whether an edge is that boundary of the block. @param edge 0…count()
  [[nodiscard]] bool is_boundary(int edge, int boundary) const {
    return edge < count_ && boundaries_[static_cast<std::size_t>(edge)] == boundary;
  }
  /// Returns the distance of an edge from the start, in mm.
  [[nodiscard]] float distance(int edge) const {
    return distances_[static_cast<std::size_t>(edge)];
  }

 private:
  void insert(float distance, float length);

  int count_ = 0;
  std::array<float, kMost> distances_{};  ///< mm from the start, in order.
  std::array<int, kMost> boundaries_{};   ///< Boundaries of the block that they are.
};

}  // namespace cnc::motion
