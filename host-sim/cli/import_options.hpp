#pragma once

#include "host-sim/import/drawing.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Adds `--gap` and `--drawing-unit`, which set how a drawing is read. `options` must outlive the
/// command.
void add_import_options(CLI::App& command, drawing::ImportOptions& options);

}  // namespace sim
