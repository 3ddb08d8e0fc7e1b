#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/contour/outline.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// A drawn contour that is cut, as strokes with the part on the left.
struct Outline {
  std::vector<Stroke> strokes;  ///< None: it is not cut.
  bool is_hole = false;
  bool is_closed = false;
  bool is_beside = false;  ///< Half a kerf beside its line; else on it.
};

/// Returns an outline for each contour of the drawing. Contours that are not cut beside their line
/// are no parts, and nothing is a hole in them.
/// @param sides by contour
/// @param faults receives the contours that no arcs follow
[[nodiscard]] std::vector<Outline> outlines_of(const drawing::Drawing& drawn,
                                               const std::vector<Side>& sides,
                                               const OutlineOptions& curves,
                                               std::vector<drawing::Fault>& faults);

/// Reverses a row of strokes.
void turn_round(std::vector<Stroke>& strokes);

/// The same loop for and from the offset.
[[nodiscard]] Contour contour_of(const std::vector<Stroke>& strokes);
[[nodiscard]] std::vector<std::vector<Stroke>> loops_of(
    const cnc::contour::ContourView<double>& view);

/// Returns the area that the strokes of a closed row enclose, positive where they turn left, mm².
[[nodiscard]] double area_of(const std::vector<Stroke>& loop);

}  // namespace sim::cut
