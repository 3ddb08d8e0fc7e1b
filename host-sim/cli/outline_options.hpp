#pragma once

#include "host-sim/contour/outline.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): theirs.
class App;
}

namespace sim {

/// Adds `--tolerance` and `--fit`: how curves of a drawing become arcs.
void add_outline_options(CLI::App& command, OutlineOptions& outline);

}  // namespace sim
