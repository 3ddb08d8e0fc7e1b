#pragma once

#include "host-sim/cli/commands.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Adds the command `joints` to `kerfline wall`. The command sets `status` when it runs.
void add_wall_joints_command(CLI::App& wall_command, ExitStatus& status);

}  // namespace sim
