#pragma once

#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Returns warnings about settings that a cut at an offset does not fulfil: leads, tabs and corner
/// loops without free space, and an overcut or lead-out of a cut that ends before a tab.
/// @param tabs the number that the settings require
[[nodiscard]] std::vector<drawing::Fault> unfulfilled(const LedCut& cut,
                                                      const LayerSettings& settings,
                                                      const drawing::Entity& entity,
                                                      unsigned tabs);

/// Returns at most one warning, about settings that a cut on its line cannot fulfil.
[[nodiscard]] std::vector<drawing::Fault> unfulfilled_on_line(const LayerSettings& settings,
                                                              const drawing::Entity& entity,
                                                              const Place& start);

}  // namespace sim::cut
