#pragma once

#include <array>
#include <cstddef>

#include "planner/motion/block/block.hpp"
#include "planner/motion/lookahead/arc_grid.hpp"

namespace cnc::motion {

/// Edges of the zones that reach into a block. Each edge is a boundary between spans, in addition
/// to those of the arc's grid. Its distance is kept exactly: a zone of some nanometres must not
/// become one of a metre.
class ZoneEdges {
 public:
  static constexpr int kMax = 4;

  /// Adds the edges of all zones. @param length of the block in mm @pre there are no edges yet
  void add(const BlockZones& head, const BlockZones& tail, float length);
  /// Numbers the edges among the boundaries of the grid. Leaves out an edge that is at one of
  /// these.
  /// @pre number() was not called before
  void number(const ArcShape& arc, const ArcGrid& grid);

  [[nodiscard]] int count() const { return count_; }
  /// Returns the number of edges before a boundary of the block. @pre number() was called
  [[nodiscard]] int before(int boundary) const {
    int before = 0;
    while (before < count_ && boundaries_[static_cast<std::size_t>(before)] < boundary) ++before;
    return before;
  }
  /// Checks whether an edge has the number `boundary` among the boundaries of the block.
  /// @param edge 0…count()
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
  std::array<float, kMax> distances_{};  ///< mm from the start, in order.
  std::array<int, kMax> boundaries_{};   ///< Their numbers among the boundaries of the block.
};

}  // namespace cnc::motion
