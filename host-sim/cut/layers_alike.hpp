#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/recipe.hpp"

namespace sim::cut {

/// Returns groups of layers that are cut beside their lines in the same way, for
/// drawing::fill_across(): an edge of one that crosses an edge of the other is one of the same
/// part, whatever the colours of both.
/// @return one number for each layer; drawing::kAloneInGroup for what is engraved, cut on its line
///         or not at all
[[nodiscard]] std::vector<std::size_t> layers_alike(const std::vector<LayerPlan>& layers);

}  // namespace sim::cut
