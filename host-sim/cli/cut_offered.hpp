#pragma once

#include <string>
#include <vector>

#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim {

/// Returns the settings of a layer. A setting that neither the options of all cuts nor a rule give
/// is taken from the drawing, with two exceptions. If the call names a material, power, feed and
/// passes of a cut are those of the material. If the drawing offers settings for lines but the
/// layer is filled, or the other way round, power, feed and passes are not taken. Throws
/// std::invalid_argument that names the option or the rule.
[[nodiscard]] cut::LayerSettings settings_of_layer(const CutCommandOptions& options,
                                                   const drawing::Layer& layer,
                                                   const std::vector<cut::LayerRule>& rules);

/// Returns a line for each layer for which the drawing offers settings: the settings that were
/// taken, and the reasons why others were not. Throws the exceptions of settings_of_layer().
[[nodiscard]] std::vector<std::string> offered_lines(const CutCommandOptions& options,
                                                     const drawing::Drawing& drawn,
                                                     const std::vector<cut::LayerRule>& rules);

}  // namespace sim
