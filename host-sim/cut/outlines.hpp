#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/contour/outline.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// A contour of the drawing as strokes, with the part on their left.
struct Outline {
  std::vector<Stroke> strokes;  ///< Strokes; empty if the contour is not cut.
  bool is_hole = false;
  bool is_closed = false;
  /// Whether the contour is cut at an offset of half a kerf from its line. Otherwise it is cut on
  /// its line.
  bool is_beside = false;
};

/// Returns an outline for each contour of the drawing. Only contours that are cut at an offset are
/// edges of parts, and only these can be holes.
/// @param sides side of each contour
/// @param faults receives the contours that could not be approximated by arcs
[[nodiscard]] std::vector<Outline> outlines_of(const drawing::Drawing& drawn,
                                               const std::vector<Side>& sides,
                                               const OutlineOptions& curves,
                                               std::vector<drawing::Fault>& faults);

/// Reverses the direction of a row of strokes.
void turn_round(std::vector<Stroke>& strokes);

/// Convert strokes of a loop to the contour that an offset requires, and the result of an offset to
/// strokes.
[[nodiscard]] Contour contour_of(const std::vector<Stroke>& strokes);
[[nodiscard]] std::vector<std::vector<Stroke>> loops_of(
    const cnc::contour::ContourView<double>& view);

/// Returns the area that the strokes of a closed row enclose, mm². It is positive if they turn
/// left.
[[nodiscard]] double area_of(const std::vector<Stroke>& loop);

}  // namespace sim::cut
