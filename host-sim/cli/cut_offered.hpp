#pragma once

#include <string>
#include <vector>

#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim {

/// Returns the settings of a layer. What neither the options of all cuts nor a rule says is as the
/// drawing offers it, but for power, feed and passes of a cut where the call names a material,
/// which gives them, and of a layer that is filled in place of its lines, or the other way round.
/// Throws std::invalid_argument that names the option or the rule.
[[nodiscard]] cut::LayerSettings settings_of_layer(const CutCommandOptions& options,
                                                   const drawing::Layer& layer,
                                                   const std::vector<cut::LayerRule>& rules);

/// Returns a line for each layer of which the drawing offers settings: those that were taken, and
/// why others were not. Throws as settings_of_layer().
[[nodiscard]] std::vector<std::string> offered_lines(const CutCommandOptions& options,
                                                     const drawing::Drawing& drawn,
                                                     const std::vector<cut::LayerRule>& rules);

}  // namespace sim
