#pragma once

#include "planner/motion/lookahead/arc_grid.hpp"
#include "planner/motion/lookahead/arc_shape.hpp"
#include "planner/motion/lookahead/zone_edges.hpp"

namespace cnc::motion {

/// The positions where the spans of a block begin and end. These are the boundaries of the arc's
/// grid (ArcGrid) and the edges of limit zones (ZoneEdges).
class SpanBoundaries {
 public:
  SpanBoundaries() = default;
  /// Makes the boundaries of a single span, which is the whole block.
  explicit SpanBoundaries(const Block& block) : arc_{block}, length_{block.length} {}

  /// Divides the block at the boundaries of the arc's grid. @pre arc().turns(), and cut_at_zones()
  /// was not called
  void divide(const ArcGrid& grid) {
    grid_ = grid;
    count_ = grid.count();
  }
  /// Divides the block at the edges of limit zones, too. @pre cut_at_zones() was not called
  void cut_at_zones(const BlockZones& head, const BlockZones& tail);

  [[nodiscard]] const ArcShape& arc() const { return arc_; }
  [[nodiscard]] const ArcGrid& grid() const { return grid_; }
  /// Returns the length of the block in mm.
  [[nodiscard]] float length() const { return length_; }
  /// Returns the number of spans. The boundaries have the numbers 0…count().
  [[nodiscard]] int count() const { return count_; }
  /// Returns the distance of a boundary from the start of the block, in mm.
  [[nodiscard]] float distance(int boundary) const;
  /// Returns the angle of the tangent at a boundary, in radians. @pre arc().turns()
  [[nodiscard]] float angle(int boundary) const;
  [[nodiscard]] Place place(int boundary) const;

  /// Return the angle of the tangent `reach` radians before the start, or after the end, of a span.
  /// The result is limited to the angles of the arc.
  [[nodiscard]] float angle_before(int span, float reach) const;
  [[nodiscard]] float angle_behind(int span, float reach) const;

 private:
  int count_ = 1;
  ArcShape arc_;
  ArcGrid grid_;
  ZoneEdges edges_;
  float length_ = 0.0F;  ///< Length of the block, mm.
};

}  // namespace cnc::motion
