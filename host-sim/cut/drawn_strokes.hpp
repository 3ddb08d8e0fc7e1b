#pragma once

#include <optional>
#include <vector>

#include "host-sim/contour/outline.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// A contour of a drawing as strokes, or why it is none.
struct DrawnStrokes {
  std::vector<Stroke> strokes;
  std::optional<drawing::Fault> fault;  ///< No strokes then.
};

/// Lines and arcs as they are, arcs of at most half a turn; curves as arcs within the tolerance.
/// @pre as of arcs_of()
[[nodiscard]] DrawnStrokes strokes_of(const drawing::DrawnContour& contour,
                                      const OutlineOptions& curves);
/// Returns the same strokes, with the rows that arcs_of() knows.
[[nodiscard]] DrawnStrokes strokes_of(const drawing::DrawnContour& contour,
                                      const OutlineOptions& curves,
                                      KnownRows& known);

}  // namespace sim::cut
