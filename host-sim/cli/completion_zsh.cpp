#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "host-sim/cli/completion.hpp"

namespace sim {
namespace {

/// Returns text for single quotes with a backslash in front of each of the `special` characters.
std::string quoted_for_zsh(const std::string& text, std::string_view special) {
  std::string quoted;
  for (const char c : text) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      if (c == '\\' || special.find(c) != std::string_view::npos) quoted += '\\';
      quoted += c;
    }
  }
  return quoted;
}

/// Returns the name of a command's zsh function: `_kerfline_kerf_advise` for `kerfline kerf
/// advise`.
std::string function_of(std::string path) {
  std::replace(path.begin(), path.end(), ' ', '_');
  return "_" + path;
}

/// Returns zsh's specification of a parameter's value, `:message:action`.
std::string zsh_value_of(const ParameterText& parameter) {
  std::string action = parameter.takes_file ? "_files" : " ";
  if (!parameter.choices.empty()) action = fmt::format("({})", fmt::join(parameter.choices, " "));
  const std::string shown = parameter.value.empty() ? parameter.names.front() : parameter.value;
  return fmt::format(
      ":{}:{}", quoted_for_zsh(shown.substr(shown.find_first_not_of(' ')), ":"), action);
}

/// Returns one `_arguments` specification for each name of an option.
std::string option_specs(const ParameterText& option) {
  const std::string description = quoted_for_zsh(first_sentence(option.description), "[]");
  std::string specs;
  for (const std::string& name : option.names) {
    const std::string others =
        option.may_repeat ? "*" : fmt::format("({})", fmt::join(option.names, " "));
    const char* join = !option.takes_value ? "" : name.starts_with("--") ? "=" : "+";
    const std::string value = option.takes_value ? zsh_value_of(option) : "";
    specs += fmt::format(" \\\n    '{}{}{}[{}]{}'", others, name, join, description, value);
  }
  return specs;
}

std::string leaf_function(const CommandText& command) {
  std::string body = "  _arguments";
  for (const ParameterText& option : command.options) body += option_specs(option);
  for (const ParameterText& positional : command.positionals) {
    const std::string count = positional.may_repeat ? "*" : "";
    body += fmt::format(" \\\n    '{}{}'", count, zsh_value_of(positional));
  }
  return fmt::format("{}() {{\n{}\n}}\n", function_of(command.path), body);
}

/// Returns the zsh function of a command with subcommands, which calls the functions of these.
std::string branch_function(std::span<const CommandText> commands, const CommandText& command) {
  std::string options;
  for (const ParameterText& option : command.options) options += option_specs(option);
  std::string names;
  std::string cases;
  for (const std::string& name : command.subcommands) {
    const std::string path = command.path + " " + name;
    const std::string help = first_sentence(command_of(commands, path).description);
    names += fmt::format("        '{}:{}'\n", name, quoted_for_zsh(help, ":"));
    cases += fmt::format("        {}) {} ;;\n", name, function_of(path));
  }
  return fmt::format(
      "{}() {{\n"
      "  local curcontext=$curcontext state\n"
      "  local -a line commands\n"
      "  _arguments -C{} \\\n    '1: :->command' '*:: :->rest'\n"
      "  case $state in\n"
      "    command)\n"
      "      commands=(\n{}      )\n"
      "      _describe -t commands command commands ;;\n"
      "    rest)\n"
      "      case $line[1] in\n{}      esac ;;\n"
      "  esac\n"
      "}}\n",
      function_of(command.path),
      options,
      names,
      cases);
}

}  // namespace

std::string zsh_completion(std::span<const CommandText> commands) {
  std::string script =
      "#compdef kerfline\n"
      "# Completion of kerfline for zsh; written by `kerfline completion zsh`.\n";
  for (const CommandText& command : commands) {
    script +=
        command.subcommands.empty() ? leaf_function(command) : branch_function(commands, command);
  }
  // compinit loads the script as a function. A script that is sourced registers the function
  // instead.
  script +=
      "if [[ $funcstack[1] == _kerfline ]]; then\n"
      "  _kerfline \"$@\"\n"
      "else\n"
      "  compdef _kerfline kerfline\n"
      "fi\n";
  return script;
}

}  // namespace sim
