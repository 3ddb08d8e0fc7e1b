#include "host-sim/cli/command_tree.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "host-sim/cli/file_options.hpp"

namespace sim {
namespace {

bool names_file(const CLI::Option& option) {
  return file_role(option).has_value() || option.get_type_name() == "DEVICE";
}

/// Returns the only values that an option accepts: `a` and `b` from CLI11's descriptions `{a,b}`
/// and `{a->0,b->1}`.
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open);
  if (open == std::string::npos || close == std::string::npos) return {};
  std::vector<std::string> choices =
      CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
  for (std::string& choice : choices) choice = choice.substr(0, choice.find("->"));
  return choices;
}

ParameterText text_of(const CLI::Option& option) {
  ParameterText text;
  for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  if (text.names.empty()) text.names.push_back(option.get_name(true));
  text.value = CLI::Formatter{}.make_option_opts(&option);
  text.description = option.get_description();
  text.choices = choices_of(option);
  text.takes_value = option.get_items_expected_max() != 0;
  text.takes_file = text.takes_value && names_file(option);
  text.may_repeat = option.get_expected_max() > 1;
  return text;
}

void add_parameters(CommandText& text, const CLI::App& app) {
  for (const CLI::Option* option : app.get_options({})) {
    auto& list = option->get_positional() ? text.positionals : text.options;
    list.push_back(text_of(*option));
  }
}

/// Returns whether a command is a group: CLI11 puts the options of a group into a command without a
/// name.
bool is_group(const CLI::App* app) { return app->get_name().empty(); }
bool is_command(const CLI::App* app) { return !is_group(app); }

CommandText text_of(const CLI::App& app, const std::string& path) {
  CommandText text{.path = path,
                   .description = app.get_description(),
                   .footer = app.get_footer(),
                   .positionals = {},
                   .options = {},
                   .subcommands = {}};
  add_parameters(text, app);
  for (const CLI::App* group : app.get_subcommands(is_group)) add_parameters(text, *group);
  for (const CLI::App* command : app.get_subcommands(is_command)) {
    text.subcommands.push_back(command->get_name());
  }
  return text;
}

}  // namespace

std::vector<CommandText> command_tree(const CLI::App& app) {
  std::vector<CommandText> tree;
  std::vector<std::pair<const CLI::App*, std::string>> open{{&app, app.get_name()}};
  while (!open.empty()) {
    const auto [command, path] = open.back();
    open.pop_back();
    tree.push_back(text_of(*command, path));
    auto below = command->get_subcommands(is_command);
    std::reverse(below.begin(), below.end());
    for (const CLI::App* next : below) open.emplace_back(next, path + " " + next->get_name());
  }
  return tree;
}

const CommandText& command_of(std::span<const CommandText> commands, const std::string& path) {
  return *std::find_if(
      commands.begin(), commands.end(), [&](const auto& command) { return command.path == path; });
}

std::string first_sentence(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  text = text.substr(0, text.find(". "));
  if (text.ends_with('.')) text.pop_back();
  return text;
}

}  // namespace sim
