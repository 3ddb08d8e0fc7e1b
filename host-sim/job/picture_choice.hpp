#pragma once

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/plot/path.hpp"

namespace sim {

/// Returns the quantity that a picture of the program shows: the depth if a mill cuts at different
/// heights, the power if a laser cuts with many different powers, as in a relief, and otherwise the
/// speed.
[[nodiscard]] Shown shown_of(const ProgrammedPath& path, const cnc::Settings& settings);

/// Returns whether the machine is a mill, which has no kerf.
[[nodiscard]] bool is_mill(const cnc::Settings& settings);

}  // namespace sim
