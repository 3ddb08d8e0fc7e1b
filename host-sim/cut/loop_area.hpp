#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/contour/curve.hpp"

namespace sim::cut {

/// The area inside a closed row of lines and arcs. The row may cross itself, as corner loops do.
/// Every point around which the row winds, in either direction, is inside.
class LoopArea {
 public:
  using Box = cnc::contour::FlatBox<double>;

  /// Makes the area inside a closed loop.
  /// @pre each stroke begins at the end of the previous one, the first stroke begins at the end of
  /// the last one, and at least one stroke is longer than a nanometre
  /// @param skin_mm distance by which the area extends beyond the loop, 0 or more. Only box()
  /// contains this skin; the caller adds it to other distances
  explicit LoopArea(std::vector<Stroke> loop, double skin_mm = 0.0);

  /// Returns the loop in counter-clockwise direction.
  [[nodiscard]] const std::vector<Stroke>& strokes() const { return loop_; }
  /// Returns the box around the area with its skin.
  [[nodiscard]] const Box& box() const { return box_; }
  [[nodiscard]] double skin_mm() const { return skin_mm_; }

  /// Returns whether a point is inside the loop. Either result is possible for a point that is
  /// within rounding of the loop.
  [[nodiscard]] bool contains(const Place& place) const;

  /// Returns the distance of a point from the loop, mm. It is positive both inside and outside.
  [[nodiscard]] double distance_to_loop(const Place& place) const;

  /// Returns whether a segment comes nearer to the loop than `mm`.
  [[nodiscard]] bool comes_near(const Place& from, const Place& to, double mm) const;

  /// Returns whether any point of a segment is inside at more than `depth_mm` from the loop. Points
  /// up to about twice this depth may be missed; deeper points are not missed.
  [[nodiscard]] bool is_crossed(const Place& from, const Place& to, double depth_mm) const;

 private:
  std::vector<Stroke> loop_;
  std::vector<Box> boxes_;  ///< Box around each stroke.
  Box box_{};
  double skin_mm_;
};

/// Returns a box that contains a stroke.
[[nodiscard]] LoopArea::Box box_around(const Stroke& stroke);

/// Returns a box extended by `mm` on all sides.
[[nodiscard]] inline LoopArea::Box grown(const LoopArea::Box& box, double mm) {
  return {box.x0 - mm, box.y0 - mm, box.x1 + mm, box.y1 + mm};
}

/// Returns the box that has two points as opposite corners.
[[nodiscard]] inline LoopArea::Box box_between(const Place& a, const Place& b) {
  return {a.x() < b.x() ? a.x() : b.x(),
          a.y() < b.y() ? a.y() : b.y(),
          a.x() < b.x() ? b.x() : a.x(),
          a.y() < b.y() ? b.y() : a.y()};
}

}  // namespace sim::cut
