#pragma once

#include "host-sim/cli/commands.hpp"

namespace sim {

/// Adds `carve` and `taper` to `kerfline wall`; each sets `status` when it runs.
void add_wall_carving_commands(CLI::App& wall_command, ExitStatus& status);

}  // namespace sim
