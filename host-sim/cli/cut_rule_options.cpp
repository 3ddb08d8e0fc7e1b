#include "host-sim/cli/cut_rule_options.hpp"

#include <CLI/CLI.hpp>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"

namespace sim {

void add_cut_rule_options(CLI::App& command, CutRuleOptions& options) {
  mark_file(
      command.add_option("--rules", options.file, "File of rules for contours, one to a line")
          ->type_name("FILE"),
      FileRole::kInput);
  command
      .add_option("--rule",
                  options.rules,
                  "One rule, such as 'hole diameter < thickness: feed=60%'; may be repeated")
      ->type_name("TEXT")
      ->allow_extra_args(false);
  command
      .add_option("--mark-power",
                  options.mark_percent,
                  "Power for contours that a rule marks, % of the layer's power")
      ->check(in_range(0.1, 100.0, "%"))
      ->type_name("%")
      ->capture_default_str();
}

std::vector<cut::ShopRule> shop_rules(const CutRuleOptions& options, InputFiles& inputs) {
  std::vector<cut::ShopRule> rules;
  if (!options.file.empty()) {
    rules = cut::read_shop_rules(inputs.read_and_add("rules", options.file), options.file);
  }
  for (const std::string& text : options.rules) {
    rules.push_back(cut::parse_shop_rule(text, "--rule"));
  }
  return rules;
}

}  // namespace sim
