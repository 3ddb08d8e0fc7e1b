#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/recipe.hpp"

namespace sim::cut {

/// Returns groups of layers that are cut in the same way at an offset from their lines, for
/// drawing::fill_across(). If edges of two layers of a group cross, both edges belong to the same
/// part.
/// @return the number of its group for each layer; drawing::kAloneInGroup for a layer that is
/// engraved, cut on its line, or not cut
[[nodiscard]] std::vector<std::size_t> layers_alike(const std::vector<LayerPlan>& layers);

}  // namespace sim::cut
