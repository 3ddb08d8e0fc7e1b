#pragma once

#include <optional>
#include <vector>

#include "host-sim/contour/outline.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// A contour of a drawing as strokes, or the reason why it has no strokes.
struct DrawnStrokes {
  std::vector<Stroke> strokes;
  std::optional<drawing::Fault> fault;  ///< The reason why there are no strokes.
};

/// Returns the strokes of a contour. Lines stay lines, arcs become arcs of at most half a turn, and
/// other curves become arcs within the tolerance.
/// @pre the same as for arcs_of()
[[nodiscard]] DrawnStrokes strokes_of(const drawing::DrawnContour& contour,
                                      const OutlineOptions& curves);
/// Returns the same strokes as strokes_of() without `known`, but fits arcs to a repeated row only
/// once.
/// @param known rows as for arcs_of()
[[nodiscard]] DrawnStrokes strokes_of(const drawing::DrawnContour& contour,
                                      const OutlineOptions& curves,
                                      KnownRows& known);

}  // namespace sim::cut
