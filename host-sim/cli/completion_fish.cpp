#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host-sim/cli/completion.hpp"

namespace sim {
namespace {

std::string quoted_for_fish(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

/// Returns the fish condition that is true if the words so far name `command` and none of its
/// subcommands.
std::string condition_of(const CommandText& command) {
  std::string condition;
  std::size_t from = command.path.find(' ');
  while (from != std::string::npos) {
    const std::size_t to = command.path.find(' ', from + 1);
    if (!condition.empty()) condition += "; and ";
    condition += "__fish_seen_subcommand_from " + command.path.substr(from + 1, to - from - 1);
    from = to;
  }
  if (command.subcommands.empty()) return condition;
  if (!condition.empty()) condition += "; and ";
  return fmt::format(
      "{}not __fish_seen_subcommand_from {}", condition, fmt::join(command.subcommands, " "));
}

/// Returns the arguments of fish's `complete` for the value of an option.
std::string fish_value_of(const ParameterText& option) {
  if (!option.takes_value) return "";
  if (!option.choices.empty()) {
    return fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
  }
  return option.takes_file ? " -r -F" : " -x";
}

std::string option_line(const std::string& condition, const ParameterText& option) {
  std::string line = fmt::format("complete -c kerfline -n '{}'", condition);
  for (const std::string& name : option.names) {
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  const std::string description = quoted_for_fish(first_sentence(option.description));
  return fmt::format("{}{} -d {}\n", line, fish_value_of(option), description);
}

std::string positional_line(const std::string& condition, const ParameterText& positional) {
  const std::string values =
      positional.takes_file ? " -F" : fmt::format(" -a '{}'", fmt::join(positional.choices, " "));
  return fmt::format("complete -c kerfline -n '{}'{}\n", condition, values);
}

std::string subcommand_line(const std::string& condition,
                            const std::string& name,
                            const CommandText& subcommand) {
  return fmt::format("complete -c kerfline -n '{}' -a {} -d {}\n",
                     condition,
                     name,
                     quoted_for_fish(first_sentence(subcommand.description)));
}

}  // namespace

std::string fish_completion(std::span<const CommandText> commands) {
  std::string script =
      "# Completion of kerfline for fish; written by `kerfline completion fish`.\n"
      "complete -c kerfline -e\n"
      "complete -c kerfline -f\n";
  for (const CommandText& command : commands) {
    const std::string condition = condition_of(command);
    for (const std::string& name : command.subcommands) {
      script += subcommand_line(condition, name, command_of(commands, command.path + " " + name));
    }
    for (const ParameterText& positional : command.positionals) {
      script += positional_line(condition, positional);
    }
    for (const ParameterText& option : command.options) script += option_line(condition, option);
  }
  return script;
}

}  // namespace sim
