#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/contour/curve.hpp"

namespace sim::cut {

/// The plane inside of a closed row of lines and arcs, which may cross itself, as corner loops do:
/// what it goes round at all, in either direction, is inside.
class LoopArea {
 public:
  using Box = cnc::contour::FlatBox<double>;

  /// @pre each stroke begins where the one before it ends, the first one at the end of the last,
  /// and one is longer than a nanometre
  /// @param skin_mm how far beyond the loop its owner counts the area, 0 or more
  explicit LoopArea(std::vector<Stroke> loop, double skin_mm = 0.0);

  /// The loop, turning left.
  [[nodiscard]] const std::vector<Stroke>& strokes() const { return loop_; }
  /// With the skin.
  [[nodiscard]] const Box& box() const { return box_; }
  [[nodiscard]] double skin_mm() const { return skin_mm_; }

  /// Returns whether a place is inside of the loop; either answer is right within rounding of the
  /// edge.
  [[nodiscard]] bool contains(const Place& place) const;

  /// Returns the distance of a place to the loop, mm, from inside as from outside.
  [[nodiscard]] double distance_to_loop(const Place& place) const;

  /// Returns whether a segment comes nearer to the loop than so many mm.
  [[nodiscard]] bool comes_near(const Place& from, const Place& to, double mm) const;

  /// Returns whether a place of a segment is inside, farther than `depth_mm` from the loop. Shallow
  /// excursions up to about twice that depth may be missed, deeper ones are not.
  [[nodiscard]] bool is_crossed(const Place& from, const Place& to, double depth_mm) const;

 private:
  std::vector<Stroke> loop_;
  std::vector<Box> boxes_;  ///< One for each stroke.
  Box box_{};
  double skin_mm_;
};

/// Returns a box that holds a stroke.
[[nodiscard]] LoopArea::Box box_around(const Stroke& stroke);

/// Returns a box that is larger by so many mm to all sides.
[[nodiscard]] inline LoopArea::Box grown(const LoopArea::Box& box, double mm) {
  return {box.x0 - mm, box.y0 - mm, box.x1 + mm, box.y1 + mm};
}

/// Returns the box with these two places as opposite corners.
[[nodiscard]] inline LoopArea::Box box_between(const Place& a, const Place& b) {
  return {a.x() < b.x() ? a.x() : b.x(),
          a.y() < b.y() ? a.y() : b.y(),
          a.x() < b.x() ? b.x() : a.x(),
          a.y() < b.y() ? b.y() : a.y()};
}

}  // namespace sim::cut
