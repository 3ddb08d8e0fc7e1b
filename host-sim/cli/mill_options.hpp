#pragma once

#include <string>

#include "host-sim/pocket/mill_program.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
}

namespace sim {

/// Adds --feed, --plunge-feed, --spindle, --spin-up and --coolant.
/// @param otherwise end of a help text; it names the source of a value that the call does not give
void add_mill_options(CLI::App& command,
                      pocket::MillSettings& mill,
                      const std::string& otherwise = {});

}  // namespace sim
