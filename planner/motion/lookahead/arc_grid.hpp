#pragma once

#include <cstdint>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/lookahead/arc_shape.hpp"

namespace cnc::motion {

/// Boundaries of the spans of an arc, by the angle of its tangent: at each multiple of 3.75° or of
/// a whole fraction of it, or at equal distances. A line is one span.
///
/// Quarter turns are among the multiples, so in a coordinate plane no axis reverses within a span.
class ArcGrid {
 public:
  static constexpr int kPerTurn = 96;
  static constexpr float kAngle = kTwoPi / static_cast<float>(kPerTurn);  ///< 3.75° in radians.
  static constexpr int kMostSpans = kPerTurn / 2 + 2;
  static constexpr int kMostFineSpans = 2 * kPerTurn + 2;  ///< With a split above 1.

  ArcGrid() = default;
  /// Divides an arc at the multiples of kAngle / `split`. @pre arc.turns(), split ≥ 1
  [[nodiscard]] static ArcGrid at_multiples(const ArcShape& arc, int split);
  /// Divides an arc into equal spans of at most kAngle. @pre arc.turns()
  [[nodiscard]] static ArcGrid of_equal_spans(const ArcShape& arc);
  /// Returns the greatest split, at most 16, with which spans take 0.7 ms each at least and are
  /// kMostFineSpans at most.
  /// @param seconds the shortest time in which the arc can be driven
  [[nodiscard]] static int finest_split(const ArcShape& arc, float seconds);

  /// Returns the number of spans. Boundaries are 0…count().
  [[nodiscard]] int count() const { return count_; }
  /// Checks whether its spans are shorter than 3.75° each.
  [[nodiscard]] bool fine() const { return fine_; }
  /// Checks whether its spans are equal, wherever the multiples of 3.75° are.
  [[nodiscard]] bool equal_spans() const { return equal_spans_; }
  /// Returns the greatest angle of a span, in radians.
  [[nodiscard]] float spacing() const { return spacing_; }

  /// Returns the angle of the tangent at a boundary, in radians. @param arc that was divided
  [[nodiscard]] float angle(const ArcShape& arc, int boundary) const;
  /// Returns its distance from the start, in mm. @pre arc.turns()
  [[nodiscard]] float distance(const ArcShape& arc, int boundary) const {
    return arc.distance_to(angle(arc, boundary));
  }
  [[nodiscard]] Place place(const ArcShape& arc, int boundary) const;

 private:
  int count_ = 1;
  float spacing_ = kAngle;    ///< kAngle / split.
  int first_multiple_ = 0;    ///< The multiple of the spacing at boundary 1.
  bool fine_ = false;         ///< The split is above 1.
  bool equal_spans_ = false;  ///< Then there are no multiples.
};

}  // namespace cnc::motion
