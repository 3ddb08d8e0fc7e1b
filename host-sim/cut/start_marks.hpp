#pragma once

#include <optional>
#include <vector>

#include "host-sim/cut/outlines.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Returns, for each contour of the drawing, where the user has marked its start: the middle of a
/// small circle or a short line on a layer with side=start that lies nearest to it.
/// @param sides by contour
/// @param faults receives marks that are far from all contours or share one with another mark
[[nodiscard]] std::vector<std::optional<Place>> marked_starts(const drawing::Drawing& drawn,
                                                              const std::vector<Side>& sides,
                                                              const std::vector<Outline>& outlines,
                                                              const OutlineOptions& curves,
                                                              std::vector<drawing::Fault>& faults);

/// Returns how far along a row its point nearest to `place` is, mm.
[[nodiscard]] double way_nearest_to(const MeasuredRow& row, const Place& place);

}  // namespace sim::cut
