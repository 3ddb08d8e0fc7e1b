#pragma once

#include <span>
#include <string>
#include <string_view>

#include "host-sim/cli/command_tree.hpp"

namespace sim {

/// Returns kerfline(1) in the roff of man. It contains the `--help` of each command, first that of
/// the program itself.
[[nodiscard]] std::string manual_page(std::span<const CommandText> commands,
                                      std::string_view version);

}  // namespace sim
