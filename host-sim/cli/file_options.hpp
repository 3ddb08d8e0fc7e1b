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

/// Use that a command makes of a file.
enum class FileRole : std::uint8_t {
  kInput,
  kOutput,
  kKept,  ///< The file is read and changed: a data base, a store, the link to a port.
};

/// Marks an option whose values are names of files, so that refuse_shared_files() knows the files.
/// Every option that names a file has to be marked. Names that cannot be a file's are refused.
CLI::Option* mark_file(CLI::Option* option, FileRole role);
[[nodiscard]] std::optional<FileRole> file_role(const CLI::Option& option);

struct NamedFile {
  std::string option;  ///< Name of the option as in the call, for messages.
  std::string name;
  FileRole role;
};

/// Returns `; NAME is still the file of before` if the file of an output exists already, for the
/// end of a message that nothing is written. Empty if there is no file, and for devices.
[[nodiscard]] std::string stale_note(const std::string& output);

/// Checks the files of a call. Throws std::invalid_argument, naming both options, if an output is
/// also an input or another output, under any name or link, and if standard output goes into such a
/// file.
void refuse_shared_files(const std::vector<NamedFile>& files);

/// Checks the files of the commands that were called, as the function above.
void refuse_shared_files(const CLI::App& app);

}  // namespace sim
