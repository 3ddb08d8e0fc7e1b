#include "host-sim/cli/unknown_word.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

#include "host-sim/report/nearest_name.hpp"

namespace sim {
namespace {

std::vector<std::string> commands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; })) {
    if (!below->get_name().empty()) names.push_back(below->get_name());
  }
  return names;
}

/// Returns the options of the command and of its groups.
std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> options = command.get_options();
  for (const CLI::App* group : command.get_subcommands([](const CLI::App*) { return true; })) {
    if (!group->get_name().empty()) continue;
    for (const CLI::Option* option : group->get_options()) options.push_back(option);
  }
  return options;
}

const CLI::Option* option_named(const CLI::App& command, const std::string& name) {
  for (const CLI::Option* option : options_of(command)) {
    if (option->check_name(name)) return option;
  }
  return nullptr;
}

/// Returns whether a command has positional arguments. A word that is no subcommand may then be one
/// of them.
bool takes_words(const CLI::App& command) {
  return std::ranges::any_of(options_of(command),
                             [](const CLI::Option* option) { return option->get_positional(); });
}

bool is_option(const std::string& word) {
  const bool is_number =
      word.size() > 1 && (std::isdigit(static_cast<unsigned char>(word[1])) != 0 || word[1] == '.');
  return word.size() > 1 && word[0] == '-' && !is_number;
}

/// Returns the message for an unknown option.
/// @param path path of the command, with `kerfline`
std::string unknown_option(const CLI::App& command,
                           const std::string& path,
                           const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options_of(command)) {
    for (const std::string& each : option->get_lnames()) names.push_back("--" + each);
    for (const std::string& each : option->get_snames()) names.push_back("-" + each);
  }
  const bool is_short = !name.starts_with("--");
  return fmt::format("{}: `{}` has no such option{}",
                     name,
                     path,
                     did_you_mean(is_short && name.size() > 2 ? "-" + name : name, names));
}

}  // namespace

std::optional<std::string> unknown_word(const CLI::App& app,
                                        const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  std::string path = app.get_name();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--") return std::nullopt;
    if (is_option(word)) {
      const std::string name = word.substr(0, word.find('='));
      const CLI::Option* option = option_named(*command, name);
      // A word may consist of several short options, or of a short option and its value.
      const bool begins_with_known =
          !name.starts_with("--") && option_named(*command, name.substr(0, 2)) != nullptr;
      if (option == nullptr && !begins_with_known) return unknown_option(*command, path, name);
      const bool takes_next = option != nullptr && option->get_items_expected_min() > 0;
      if (takes_next && name == word) ++i;
      continue;
    }
    const std::vector<std::string> below = commands_of(*command);
    if (below.empty()) continue;
    if (std::ranges::find(below, word) == below.end()) {
      if (takes_words(*command)) continue;
      return fmt::format("{}: no such command; there are {}{}",
                         word,
                         fmt::join(below, " "),
                         did_you_mean(word, below));
    }
    command = command->get_subcommand(word);
    path += " " + word;
  }
  return std::nullopt;
}

}  // namespace sim
