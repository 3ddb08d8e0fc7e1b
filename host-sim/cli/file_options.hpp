#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace sim {

/// Use of a file by a command.
enum class FileRole : std::uint8_t {
  kInput,
  kOutput,
  kKept,  ///< The file is read and changed: a data base, a store, the link to a port.
};

/// Marks an option whose values are names of files, so that refuse_shared_files() checks the files.
/// Every option that names a file must be marked. The option refuses empty names, and `-` for
/// outputs.
CLI::Option* mark_file(CLI::Option* option, FileRole role);
[[nodiscard]] std::optional<FileRole> file_role(const CLI::Option& option);

struct NamedFile {
  std::string option;  ///< Name of the option as in the call, for messages.
  std::string name;
  FileRole role;
};

/// Returns `; NAME is still the earlier file` if the file of an output exists already, for the end
/// of a message which reports that nothing was written. Empty if there is no file, and for devices.
[[nodiscard]] std::string stale_note(const std::string& output);

/// Checks the files of a call. Throws std::invalid_argument, naming both options, if an output is
/// also an input or another output, under any name or link, and if standard output goes into such a
/// file.
void refuse_shared_files(const std::vector<NamedFile>& files);

/// Checks all files of the commands that were called. Throws as the overload above does.
void refuse_shared_files(const CLI::App& app);

}  // namespace sim
