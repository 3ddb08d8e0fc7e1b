#pragma once

#include <span>
#include <string>
#include <string_view>

#include "host-sim/cli/command_tree.hpp"

namespace sim {

/// Returns kerfline(1) as man's roff. It has the `--help` of each command, beginning with the
/// program itself.
[[nodiscard]] std::string manual_page(std::span<const CommandText> commands,
                                      std::string_view version);

}  // namespace sim
