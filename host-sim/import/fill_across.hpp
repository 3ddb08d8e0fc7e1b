#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

/// Group number of a layer whose contours fill areas without contours of other layers.
inline constexpr std::size_t kAloneInGroup = static_cast<std::size_t>(-1);

/// Replaces overlapping closed contours of several layers by the outlines of the area that they
/// fill together, as fill() does within one layer. Each outline gets the layer of the first contour
/// that it replaces. Adds notes and faults to those of the drawing.
/// @param groups group number of each layer: layers with equal numbers fill areas together, and a
/// layer with kAloneInGroup fills areas alone
/// @param options options with which the drawing was read
/// @return whether contours were replaced; the numbers of contours then change
/// @pre one group for each layer
bool fill_across(Drawing& drawn,
                 const std::vector<std::size_t>& groups,
                 const ImportOptions& options);

}  // namespace sim::drawing
