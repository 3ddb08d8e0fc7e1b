#pragma once

#include <memory>

#include "host-sim/cut/safety.hpp"

namespace CLI {
class App;
}

namespace sim {

struct CutCommandOptions;

/// Adds the options of `kerfline cut` for an order that is safe to run.
void add_cut_safety_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options);

}  // namespace sim
