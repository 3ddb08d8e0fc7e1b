#pragma once

#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Returns warnings about settings that a cut at an offset does not fulfil. These are leads, tabs
/// and corner loops without free space, and the overcut and lead-out of a cut that ends before a
/// tab.
/// @param tabs number of tabs that the settings require
[[nodiscard]] std::vector<drawing::Fault> unfulfilled(const LedCut& cut,
                                                      const LayerSettings& settings,
                                                      const drawing::Entity& entity,
                                                      unsigned tabs);

/// Returns a warning that lists the settings that a cut on its line cannot fulfil; none if it
/// fulfils all settings.
[[nodiscard]] std::vector<drawing::Fault> unfulfilled_on_line(const LayerSettings& settings,
                                                              const drawing::Entity& entity,
                                                              const Place& start);

}  // namespace sim::cut
