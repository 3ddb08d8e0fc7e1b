#pragma once

#include <vector>

#include "host-sim/cli/cut_beam.hpp"
#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cut/recipe.hpp"

namespace sim {

/// Inputs from which the powers and feeds of layers are chosen.
struct CutSource {
  const CutCommandOptions& options;
  const CutKerf& kerf;
  const cut::Beam& beam;
};

/// Reads the rules for layers of a call. Throws std::invalid_argument that names the option, or the
/// line of the file, of a wrong rule. A rule for a layer that the drawing does not have is wrong,
/// too.
[[nodiscard]] std::vector<cut::LayerRule> layer_rules_of(const CutCommandOptions& options,
                                                         const drawing::Drawing& drawn,
                                                         InputFiles& inputs);

/// Returns `base` with the settings of all cuts. Throws std::invalid_argument that names the
/// option.
[[nodiscard]] cut::LayerSettings common_settings(const CutCommandOptions& options,
                                                 cut::LayerSettings base = {});

/// Returns the settings of all cuts, then those of each driven layer. A power may still be a share
/// of the full power. Throws the exceptions of settings_of_layer().
[[nodiscard]] std::vector<cut::LayerSettings> power_wishes(
    const CutCommandOptions& options,
    const drawing::Drawing& drawn,
    const std::vector<cut::LayerRule>& rules);

/// Returns settings, power and feed of each layer of a drawing by the options of the call. Layers
/// that are skipped need neither power nor feed. Throws std::invalid_argument that names the
/// option, the file or the layer.
[[nodiscard]] std::vector<cut::LayerPlan> layers_of(const CutSource& source,
                                                    const drawing::Drawing& drawn,
                                                    const std::vector<cut::LayerRule>& rules);

/// Returns the plans of the contours for which the shop has rules. Throws the exceptions of
/// layers_of().
[[nodiscard]] cut::Recipes recipes_of(const CutSource& source,
                                      const drawing::Drawing& drawn,
                                      const std::vector<cut::LayerPlan>& layers,
                                      InputFiles& inputs);

}  // namespace sim
