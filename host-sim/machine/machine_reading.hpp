#pragma once

#include <string>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// What a machine with these settings makes of a program's words: the programmed path and, where
/// G41 and G42 ask for it, the way beside it, by tools, widths, and the kerf tables that a
/// controller has or is sent.
[[nodiscard]] ProgrammedPath read_for_machine(const std::string& text,
                                              const cnc::Settings& settings);

}  // namespace sim
