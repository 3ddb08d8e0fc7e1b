#pragma once

#include <optional>
#include <vector>

#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Returns, for each contour of the drawing, the point that the user has marked as its start, if
/// any. A mark is a small circle or a short line on a layer with side=start. It marks the contour
/// that is nearest to the mark. The returned point is the middle of the mark.
/// @param sides side of each contour
/// @param faults receives marks that are far from all contours, and further marks of a contour that
/// already has one
[[nodiscard]] std::vector<std::optional<Place>> marked_starts(const drawing::Drawing& drawn,
                                                              const std::vector<Side>& sides,
                                                              const std::vector<Outline>& outlines,
                                                              const OutlineOptions& curves,
                                                              std::vector<drawing::Fault>& faults);

/// Returns the distance along a row to the point of the row that is nearest to `place`, mm.
[[nodiscard]] double way_nearest_to(const MeasuredRow& row, const Place& place);

}  // namespace sim::cut
