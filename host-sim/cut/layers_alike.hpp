#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/recipe.hpp"

namespace sim::cut {

/// Returns groups of layers that are cut at an offset from their lines in the same way, for
/// drawing::fill_across(). If an edge of one such layer crosses an edge of another, both edges
/// belong to the same part, whatever the colours of the layers.
/// @return one number for each layer; drawing::kAloneInGroup for a layer that is engraved, cut on
/// its line, or not cut at all
[[nodiscard]] std::vector<std::size_t> layers_alike(const std::vector<LayerPlan>& layers);

}  // namespace sim::cut
