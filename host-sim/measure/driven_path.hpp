#pragma once

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "planner/motion/block/limits.hpp"

namespace sim {

/// Returns the options with which a machine with these settings reads a program.
[[nodiscard]] ReadOptions read_options_for(const cnc::Settings& settings);

/// Returns the path that the product's path stage makes of a programmed path within its tolerances:
/// rounded, welded, with exact stops. The elements come one by one without a pause. The result is
/// for figures per driven millimetre. The distance from the program is measured on the programmed
/// path instead.
[[nodiscard]] ProgrammedPath driven_path(const ProgrammedPath& programmed,
                                         const cnc::motion::Limits& limits);

}  // namespace sim
