#pragma once

#include <optional>
#include <string>

#include "host-sim/cut/machine_profile.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Adds `--machine`: the file of a machine profile, or the name of a shipped profile.
void add_machine_option(CLI::App& command, std::string& machine);

/// Returns the profile that `--machine` names; empty if `machine` is empty. Throws
/// std::invalid_argument with the names of the shipped profiles if no profile has this name. Also
/// throws the exceptions of read_machine_profile().
[[nodiscard]] std::optional<cut::MachineProfile> machine_profile_of(const std::string& machine);

}  // namespace sim
