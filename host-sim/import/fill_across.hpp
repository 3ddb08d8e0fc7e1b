#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/import/drawing.hpp"

namespace sim::drawing {

/// The number of a layer whose contours fill nothing together with those of others.
inline constexpr std::size_t kAloneInGroup = static_cast<std::size_t>(-1);

/// Reads closed contours of several layers that overlap as the shape that they fill together, as
/// those of one layer have been read; see fill(). What is made of them has the layer of the first
/// one. Notes and faults are added to those of the drawing.
/// @param groups by layer: those of one number fill together; kAloneInGroup: by itself
/// @param options as the drawing was read with
/// @return whether contours were replaced; their numbers are others then
/// @pre one group for each layer
bool fill_across(Drawing& drawn,
                 const std::vector<std::size_t>& groups,
                 const ImportOptions& options);

}  // namespace sim::drawing
