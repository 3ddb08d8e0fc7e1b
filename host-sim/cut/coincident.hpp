#pragma once

#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Returns how deep a contour is cut that is treated so: 3 through, beside its line, 2 on it, 1 for
/// a mark, 0 for none.
[[nodiscard]] int depth_of(Side side);

/// Lets one of contours that lie on each other on several layers be driven: the one that is cut
/// beside its line before one on the line, that before one that is engraved, and of the rest the
/// first one drawn.
/// @param sides by contour; those of the others become kSkip
/// @return a warning for each of them
[[nodiscard]] std::vector<drawing::Fault> skip_coincident(const drawing::Drawing& drawn,
                                                          std::vector<Side>& sides);

}  // namespace sim::cut
