#pragma once

namespace CLI {
class App;
}

namespace sim {

/// Adds `kerfline kerf import`.
void add_kerf_import_command(CLI::App& kerf);

/// Adds `kerfline kerf test-grid`.
void add_kerf_test_grid_command(CLI::App& kerf);

/// Adds the commands of `kerfline kerf` that write files: plot, calibrate, image.
void add_kerf_output_commands(CLI::App& kerf);

}  // namespace sim
