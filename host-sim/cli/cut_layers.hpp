#pragma once

#include <vector>

#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cut/recipe.hpp"

namespace sim {

/// Returns settings, power and feed of each layer of a drawing by the options of the call; layers
/// that are skipped need neither power nor feed. Throws std::invalid_argument that names the
/// option, the file or the layer.
[[nodiscard]] std::vector<cut::LayerPlan> layers_of(const CutCommandOptions& options,
                                                    const drawing::Drawing& drawn,
                                                    const MaterialRecord& record,
                                                    InputFiles& inputs);

/// Returns the plans of the contours for which the shop has rules. Throws as layers_of().
[[nodiscard]] cut::Recipes recipes_of(const CutCommandOptions& options,
                                      const drawing::Drawing& drawn,
                                      const std::vector<cut::LayerPlan>& layers,
                                      const MaterialRecord& record,
                                      InputFiles& inputs);

}  // namespace sim
