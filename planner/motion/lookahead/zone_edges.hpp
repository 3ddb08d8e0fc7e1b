#pragma once

#include <array>
#include <cstddef>

#include "planner/motion/block/block.hpp"
#include "planner/motion/lookahead/arc_grid.hpp"

namespace cnc::motion {

/// Edges of the limit zones that reach into a block. Each edge is a boundary between spans, in
/// addition to the boundaries of the arc's grid. Its distance is stored exactly, because the zone
/// of a block may be as short as some nanometres.
class ZoneEdges {
 public:
  static constexpr int kMax = 4;

  /// Adds the edges of all limit zones.
  /// @param length length of the block, mm
  /// @pre there are no edges yet
  void add(const BlockZones& head, const BlockZones& tail, float length);
  /// Numbers the edges together with the boundaries of the grid. Removes an edge that is equal to a
  /// boundary of the grid.
  /// @pre number() was not called before
  void number(const ArcShape& arc, const ArcGrid& grid);

  [[nodiscard]] int count() const { return count_; }
  /// Returns the number of edges before a boundary of the block. @pre number() was called
  [[nodiscard]] int before(int boundary) const {
    int before = 0;
    while (before < count_ && boundaries_[static_cast<std::size_t>(before)] < boundary) ++before;
    return before;
  }
  /// Checks whether an edge has the number `boundary` among all boundaries of the block.
  /// @param edge 0…count()
  [[nodiscard]] bool is_boundary(int edge, int boundary) const {
    return edge < count_ && boundaries_[static_cast<std::size_t>(edge)] == boundary;
  }
  /// Returns the distance of an edge from the start of the block, in mm.
  [[nodiscard]] float distance(int edge) const {
    return distances_[static_cast<std::size_t>(edge)];
  }

 private:
  void insert(float distance, float length);

  int count_ = 0;
  /// Distances from the start of the block, mm, in rising order.
  std::array<float, kMax> distances_{};
  /// Numbers of the edges among all boundaries of the block.
  std::array<int, kMax> boundaries_{};
};

}  // namespace cnc::motion
