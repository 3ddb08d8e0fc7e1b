#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "host-sim/contour/outline.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

/// Converts equal Bézier curves to equal arcs at all points of the drawing, in either direction.
///
/// Arcs are normally fitted to whole rows of curves. A curve that is drawn twice, with different
/// neighbours in its row, would get different arcs each time. Between these arcs, there would be
/// areas about a micrometre wide that the drawing does not have, and coincident lines would not
/// cancel.
class DoubledCurves {
 public:
  /// Counts how often each Bézier curve of a contour is drawn.
  /// @pre with_arcs() has not been called: all contours are counted first
  void count(const DrawnContour& contour);

  /// Returns a contour in which arcs replace the curves that were counted more than once.
  [[nodiscard]] DrawnContour with_arcs(const DrawnContour& contour,
                                       const OutlineOptions& options,
                                       KnownRows& rows);

 private:
  /// Coordinates of the four control points in units of 1e-7 mm. The list begins at the end point
  /// that is first in sorting order.
  using Key = std::array<std::int64_t, 8>;

  struct Known {
    std::size_t count = 0;
    /// Arcs in the direction of the key; they are computed when they are first needed.
    std::vector<Shape> arcs{};
  };

  /// Returns the key of a curve.
  /// @param is_backwards set to true if the key has the curve's points in reverse order
  [[nodiscard]] static Key key_of(const Bezier& curve, bool& is_backwards);
  [[nodiscard]] static std::vector<Shape> arcs_along(const Bezier& curve,
                                                     const OutlineOptions& options,
                                                     KnownRows& rows);

  std::map<Key, Known> known_;
};

}  // namespace sim::drawing
