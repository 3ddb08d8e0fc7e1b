#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

/// Group number of a layer whose contours do not fill areas together with contours of other layers.
inline constexpr std::size_t kAloneInGroup = static_cast<std::size_t>(-1);

/// Replaces overlapping closed contours of several layers by the outlines of the area that they
/// fill together, as fill() does within one layer. The outlines get the layer of the first contour.
/// Notes and faults are added to those of the drawing.
/// @param groups group number of each layer: layers with equal numbers fill together;
///        kAloneInGroup: the layer is by itself
/// @param options options with which the drawing was read
/// @return whether contours were replaced; the numbers of contours then change
/// @pre one group for each layer
bool fill_across(Drawing& drawn,
                 const std::vector<std::size_t>& groups,
                 const ImportOptions& options);

}  // namespace sim::drawing
