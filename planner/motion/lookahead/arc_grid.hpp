#pragma once

#include <cstdint>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/lookahead/arc_shape.hpp"

namespace cnc::motion {

/// Boundaries of the spans into which an arc is divided. They are either at equal distances, or
/// where the angle of the tangent is a multiple of 3.75° / split. The split is an integer: the
/// number of spans per 3.75°. A line is a single span.
///
/// Quarter turns are among the multiples, so in a coordinate plane no axis reverses within a span.
class ArcGrid {
 public:
  static constexpr int kPerTurn = 96;
  static constexpr float kAngle = kTwoPi / static_cast<float>(kPerTurn);  ///< 3.75° in radians.
  static constexpr int kMaxSpans = kPerTurn / 2 + 2;
  /// Greatest number of spans with a split above 1.
  static constexpr int kMaxFineSpans = 2 * kPerTurn + 2;

  ArcGrid() = default;
  /// Divides an arc at the multiples of kAngle / `split`. @pre arc.turns(), split ≥ 1
  [[nodiscard]] static ArcGrid at_multiples(const ArcShape& arc, int split);
  /// Divides an arc into equal spans of at most kAngle. @pre arc.turns()
  [[nodiscard]] static ArcGrid of_equal_spans(const ArcShape& arc);
  /// Returns the greatest split for at_multiples(), at most 16, with which each span takes at least
  /// 0.7 ms and the arc has at most kMaxFineSpans spans.
  /// @param seconds shortest time in which the arc can be driven
  [[nodiscard]] static int finest_split(const ArcShape& arc, float seconds);

  /// Returns the number of spans. The boundaries are numbered 0…count().
  [[nodiscard]] int count() const { return count_; }
  /// Checks whether the split is above 1, so that each span is shorter than 3.75°.
  [[nodiscard]] bool fine() const { return fine_; }
  /// Checks whether the boundaries are at equal distances instead of multiples of an angle.
  [[nodiscard]] bool equal_spans() const { return equal_spans_; }
  /// Returns the greatest angle by which the arc turns on a span, in radians.
  [[nodiscard]] float spacing() const { return spacing_; }

  /// Returns the angle of the tangent at a boundary, in radians.
  /// @param arc the arc that this grid divides
  [[nodiscard]] float angle(const ArcShape& arc, int boundary) const;
  /// Returns the distance of a boundary from the start of the arc, in mm. @pre arc.turns()
  [[nodiscard]] float distance(const ArcShape& arc, int boundary) const {
    return arc.distance_to(angle(arc, boundary));
  }
  [[nodiscard]] Place place(const ArcShape& arc, int boundary) const;

 private:
  int count_ = 1;
  float spacing_ = kAngle;    ///< Angle between two boundaries, kAngle / split, in radians.
  int first_multiple_ = 0;    ///< Angle at boundary 1 as a multiple of spacing_.
  bool fine_ = false;         ///< True if the split is above 1.
  bool equal_spans_ = false;  ///< If true, first_multiple_ is unused.
};

}  // namespace cnc::motion
