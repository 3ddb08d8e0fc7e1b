#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host-sim/cli/completion.hpp"

namespace sim {
namespace {

// The script uses plain bash, because the helpers of the bash-completion package may be missing. It
// skips the word `=` that bash may see between `--option` and its value.
constexpr const char* kBashScript =
    R"(# Completion of kerfline for bash; written by `kerfline completion bash`.
_kerfline() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
  local command=kerfline kind= words= index
  COMPREPLY=()
  for ((index = 1; index < COMP_CWORD; ++index)); do
    case "$command ${{COMP_WORDS[index]}}" in
{commands}) command+=" ${{COMP_WORDS[index]}}" ;;
    esac
  done
  [[ $word == = ]] && word=
  [[ $before == = ]] && before=${{COMP_WORDS[COMP_CWORD-2]}}
  case "$command $before" in
{values}  esac
  if [[ -z $kind ]]; then
    case "$command" in
{words}    esac
    [[ $word == -* ]] && kind=words
  fi
  if [[ $kind == words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  else
    compopt -o filenames 2>/dev/null
    [[ $kind == both ]] && mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
    mapfile -t -O "${{#COMPREPLY[@]}}" COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -F _kerfline kerfline
)";

/// Returns a branch of the script's `case` for an option with a value: the words that may follow
/// it.
std::string value_case(const CommandText& command, const ParameterText& option) {
  std::vector<std::string> patterns;
  for (const std::string& name : option.names) {
    patterns.push_back(fmt::format("'{} {}'", command.path, name));
  }
  std::string action = option.takes_file ? "kind=files" : "return";
  if (!option.choices.empty()) {
    action = fmt::format("kind=words words='{}'", fmt::join(option.choices, " "));
  }
  return fmt::format("    {}) {} ;;\n", fmt::join(patterns, "|"), action);
}

/// Returns a branch of the script's `case` for a command: its subcommands, the values that its
/// positional arguments accept, and its options.
std::string words_case(const CommandText& command) {
  std::vector<std::string> words = command.subcommands;
  bool takes_files = false;
  for (const ParameterText& positional : command.positionals) {
    words.insert(words.end(), positional.choices.begin(), positional.choices.end());
    takes_files = takes_files || positional.takes_file;
  }
  for (const ParameterText& option : command.options) {
    words.insert(words.end(), option.names.begin(), option.names.end());
  }
  const char* const with_files = command.subcommands.empty() ? "files" : "both";
  return fmt::format("      '{}') kind={} words='{}' ;;\n",
                     command.path,
                     takes_files ? with_files : "words",
                     fmt::join(words, " "));
}

}  // namespace

std::string bash_completion(std::span<const CommandText> commands) {
  std::vector<std::string> paths;
  std::string values;
  std::string words;
  for (const CommandText& command : commands) {
    if (&command != &commands.front()) paths.push_back(fmt::format("      '{}'", command.path));
    for (const ParameterText& option : command.options) {
      if (option.takes_value) values += value_case(command, option);
    }
    words += words_case(command);
  }
  return fmt::format(kBashScript,
                     fmt::arg("commands", fmt::join(paths, "|\\\n")),
                     fmt::arg("values", values),
                     fmt::arg("words", words));
}

}  // namespace sim
