#pragma once

#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/lead.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// What the settings ask for and a cut beside its line did not get, as warnings: leads, tabs and
/// corner loops without room.
/// @param tabs that were asked for
[[nodiscard]] std::vector<drawing::Fault> unfulfilled(const LedCut& cut,
                                                      const drawing::Entity& entity,
                                                      unsigned tabs);

/// What the settings ask for and no cut on its line has. At most one warning.
[[nodiscard]] std::vector<drawing::Fault> unfulfilled_on_line(const LayerSettings& settings,
                                                              const drawing::Entity& entity,
                                                              const Place& start);

}  // namespace sim::cut
