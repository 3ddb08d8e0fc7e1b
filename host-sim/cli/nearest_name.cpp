#include "host-sim/cli/nearest_name.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

namespace sim {
namespace {

/// Optimal string alignment distance.
std::size_t slips_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t other = a[i - 1] == b[j - 1] ? 0 : 1;
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + other});
      const bool exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

std::vector<std::string> commands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; })) {
    if (!below->get_name().empty()) names.push_back(below->get_name());
  }
  return names;
}

/// Of the command and of its groups of options.
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

bool is_option(const std::string& word) {
  const bool is_number =
      word.size() > 1 && (std::isdigit(static_cast<unsigned char>(word[1])) != 0 || word[1] == '.');
  return word.size() > 1 && word[0] == '-' && !is_number;
}

std::string message(const std::string& word,
                    const std::string& what,
                    const std::optional<std::string>& nearest) {
  return fmt::format("{}: {}{}", word, what, nearest ? "; did you mean " + *nearest + "?" : "");
}

std::string unknown_option(const CLI::App& command, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options_of(command)) {
    for (const std::string& each : option->get_lnames()) names.push_back("--" + each);
    for (const std::string& each : option->get_snames()) names.push_back("-" + each);
  }
  return message(name,
                 fmt::format("`kerfline {}` has no such option", command.get_name()),
                 nearest_name(name, names));
}

}  // namespace

std::optional<std::string> nearest_name(const std::string& word,
                                        const std::vector<std::string>& names) {
  std::optional<std::string> nearest;
  std::size_t fewest = std::max<std::size_t>(word.size(), 3) / 3 + 1;
  std::vector<std::string> begun;
  for (const std::string& name : names) {
    if (name.starts_with(word)) begun.push_back(name);
    const std::size_t slips = slips_between(word, name);
    if (slips >= fewest) continue;
    fewest = slips;
    nearest = name;
  }
  return begun.size() == 1 ? begun.front() : nearest;
}

std::optional<std::string> unknown_word(const CLI::App& app,
                                        const std::vector<std::string>& words) {
  const CLI::App* command = &app;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--") return std::nullopt;
    if (is_option(word)) {
      const std::string name = word.substr(0, word.find('='));
      const CLI::Option* option = option_named(*command, name);
      // Letters of short options may stand together.
      if (option == nullptr && name.starts_with("--")) return unknown_option(*command, name);
      const bool takes_next = option != nullptr && option->get_items_expected_min() > 0;
      if (takes_next && name == word) ++i;
      continue;
    }
    const std::vector<std::string> below = commands_of(*command);
    if (below.empty()) continue;
    if (std::ranges::find(below, word) == below.end()) {
      std::string what = "no such command; there are";
      for (const std::string& name : below) what += " " + name;
      return message(word, what, nearest_name(word, below));
    }
    command = command->get_subcommand(word);
  }
  return std::nullopt;
}

}  // namespace sim
