#pragma once

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/plot/path.hpp"

namespace sim {

/// What a picture of the program is to show: of a mill that goes up and down the depth, of a laser
/// whose power changes throughout, as in a relief, the power, else the speed.
[[nodiscard]] Shown shown_of(const ProgrammedPath& path, const cnc::Settings& settings);

/// Whether the machine is a mill, which has no kerf.
[[nodiscard]] bool is_mill(const cnc::Settings& settings);

}  // namespace sim
