#pragma once

#include "host-sim/cli/commands.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Adds `wall joints` below `wall`.
void add_wall_joints_command(CLI::App& wall_command, ExitStatus& status);

}  // namespace sim
