#pragma once

#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Returns the rank of a side by the depth of its cut: 3 for a cut next to the line, 2 for a cut on
/// the line, 1 for an engraved line, 0 if the beam does not follow the line.
[[nodiscard]] int depth_of(Side side);

/// Selects one contour to be driven where contours on several layers lie on top of each other. A
/// contour that is cut next to its line has precedence over one that is cut on its line, and this
/// over one that is engraved. Among contours of equal precedence, the first one drawn is selected.
/// @param sides side of each contour; becomes kSkip for contours that are not selected
/// @return a warning for each contour that is skipped
[[nodiscard]] std::vector<drawing::Fault> skip_coincident(const drawing::Drawing& drawn,
                                                          std::vector<Side>& sides);

}  // namespace sim::cut
