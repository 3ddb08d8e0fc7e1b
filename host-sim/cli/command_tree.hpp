#pragma once

#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sim {

/// An option, a flag or a positional argument, as `--help` prints it.
struct ParameterText {
  /// All names, such as `-o` and `--output`; for a positional argument its only name.
  std::vector<std::string> names;
  /// Text of the value, such as ` FILE REQUIRED` or ` Z=-10`; empty for a flag.
  std::string value;
  std::string description;
  /// The only values that the parameter accepts; empty if it accepts any value.
  std::vector<std::string> choices;
  bool takes_value = false;
  bool takes_file = false;  ///< Whether the value is the name of a file, of a link or of a device.
  bool may_repeat = false;
};

/// One command with all texts that `--help` prints about it.
struct CommandText {
  std::string path;  ///< Names from the program down to the command: `kerfline kerf advise`.
  std::string description;
  std::string footer;
  std::vector<ParameterText> positionals;
  std::vector<ParameterText> options;
  std::vector<std::string> subcommands;  ///< Names of the subcommands, without this command's path.
};

/// Returns `app` and all commands below it. Each command comes before its subcommands.
[[nodiscard]] std::vector<CommandText> command_tree(const CLI::App& app);

/// Returns the command of `path`, which must be in the list.
[[nodiscard]] const CommandText& command_of(std::span<const CommandText> commands,
                                            const std::string& path);

/// Returns the first sentence of a description on one line, without the full stop.
[[nodiscard]] std::string first_sentence(std::string text);

}  // namespace sim
