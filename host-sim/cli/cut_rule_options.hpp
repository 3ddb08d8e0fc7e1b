#pragma once

#include <string>
#include <vector>

#include "host-sim/cli/input_files.hpp"
#include "host-sim/cut/recipe.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline cut` for the rules of the shop.
struct CutRuleOptions {
  std::vector<std::string> rules;  ///< Texts of rules. They come after the rules of the file.
  std::string file;
  double mark_percent = 10.0;
};

/// Adds `--rules`, `--rule` and `--mark-power`.
void add_cut_rule_options(CLI::App& command, CutRuleOptions& options);

/// Reads the rules of a call. Throws std::invalid_argument naming the option or the line of the
/// file, and the column, of a wrong rule.
[[nodiscard]] std::vector<cut::ShopRule> shop_rules(const CutRuleOptions& options,
                                                    InputFiles& inputs);

}  // namespace sim
