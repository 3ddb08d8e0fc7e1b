#pragma once

#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Lists the wishes of the settings that an offset cut does not fulfil, as warnings: leads, tabs
/// and corner loops without room, and an overcut or lead out of a cut that ends before a tab.
/// @param tabs the number that the settings require
[[nodiscard]] std::vector<drawing::Fault> unfulfilled(const LedCut& cut,
                                                      const LayerSettings& settings,
                                                      const drawing::Entity& entity,
                                                      unsigned tabs);

/// Lists the wishes of the settings that no cut on its line fulfils. At most one warning.
[[nodiscard]] std::vector<drawing::Fault> unfulfilled_on_line(const LayerSettings& settings,
                                                              const drawing::Entity& entity,
                                                              const Place& start);

}  // namespace sim::cut
