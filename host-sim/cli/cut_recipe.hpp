#pragma once

#include <memory>
#include <string>

#include "host-sim/cli/cut_options.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Adds `--recipe` and `--save-recipe`.
void add_cut_recipe_options(CLI::App& command, CutCommandOptions& options);

/// Gives the options of the call what its recipe says: what the call says itself goes before it,
/// and rules of the call come after those of the recipe. Files are named from the folder of the
/// recipe. Throws std::invalid_argument `FILE: /key: reason`, and as read_text() does.
void apply_recipe(CLI::App& command, CutCommandOptions& options);

/// Writes the options in force as a recipe, but for the drawing and the outputs, where that is
/// wanted.
void save_recipe(const CLI::App& command, const CutCommandOptions& options);

}  // namespace sim
