#pragma once

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "planner/motion/block/limits.hpp"

namespace sim {

/// How a machine with these settings understands a program.
[[nodiscard]] ReadOptions read_options_for(const cnc::Settings& settings);

/// What the product's path stage makes of a programmed path within its tolerances when the
/// elements come one by one without a pause: rounded, welded, with its exact stops.
/// For what is asked of each millimetre driven; how far that is from the program is
/// measured on the programmed path.
[[nodiscard]] ProgrammedPath driven_path(const ProgrammedPath& programmed,
                                         const cnc::motion::Limits& limits);

}  // namespace sim
