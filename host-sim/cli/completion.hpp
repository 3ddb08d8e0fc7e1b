#pragma once

#include <span>
#include <string>

#include "host-sim/cli/command_tree.hpp"

namespace sim {

/// Each function returns the script with which a shell completes the words after `kerfline`:
/// commands, options, the values of options that accept only listed values, and names of files.
[[nodiscard]] std::string bash_completion(std::span<const CommandText> commands);
[[nodiscard]] std::string zsh_completion(std::span<const CommandText> commands);
[[nodiscard]] std::string fish_completion(std::span<const CommandText> commands);

}  // namespace sim
