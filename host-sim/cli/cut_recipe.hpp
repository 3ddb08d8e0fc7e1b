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

/// Applies the recipe to the options of the call. Options of the call override those of the recipe.
/// Rules of the call come after those of the recipe. Names of files are relative to the folder of
/// the recipe. Throws std::invalid_argument `FILE: /key: reason`, and as read_text() does.
void apply_recipe(CLI::App& command, CutCommandOptions& options);

/// Writes all options except the drawing and the outputs as a recipe, if the call requires it.
void save_recipe(const CLI::App& command, const CutCommandOptions& options);

}  // namespace sim
