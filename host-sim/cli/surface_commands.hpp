#pragma once

#include "host-sim/cli/commands.hpp"

namespace sim {

/// Adds `probe-grid` to `kerfline surface`; the command sets `status` when it runs.
void add_probe_grid_command(CLI::App& surface_command, ExitStatus& status);

}  // namespace sim
