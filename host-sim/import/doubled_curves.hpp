#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "host-sim/contour/outline.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

/// Makes the same arcs of a Bézier curve wherever it is drawn, in either direction.
///
/// Arcs are fitted to rows of curves, so that a curve that is drawn twice, with other curves
/// beside it, gets other arcs each time: between them are areas a micrometre wide that are not
/// drawn, and lines that lie on each other do not cancel.
class DoubledCurves {
 public:
  /// Counts the curves of a contour. Call for all contours first.
  void count(const DrawnContour& contour);

  /// Returns a contour with arcs in place of its curves that were counted more than once.
  [[nodiscard]] DrawnContour with_arcs(const DrawnContour& contour,
                                       const OutlineOptions& options,
                                       KnownRows& rows);

 private:
  /// Control points in units of 1e-7 mm, from the end that comes first in order.
  using Key = std::array<std::int64_t, 8>;

  struct Known {
    std::size_t count = 0;
    std::vector<Shape> arcs{};  ///< Along the key; made when they are wanted first.
  };

  /// Returns the key of a curve. @param is_backwards set if its points are those of the key
  /// reversed
  [[nodiscard]] static Key key_of(const Bezier& curve, bool& is_backwards);
  [[nodiscard]] static std::vector<Shape> arcs_along(const Bezier& curve,
                                                     const OutlineOptions& options,
                                                     KnownRows& rows);

  std::map<Key, Known> known_;
};

}  // namespace sim::drawing
