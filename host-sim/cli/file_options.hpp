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

/// The use that a command makes of a file.
enum class FileRole : std::uint8_t {
  kInput,
  kOutput,
  kKept,  ///< Read and changed: a data base, a store, the link to a port.
};

/// Marks an option whose values are names of files, so that refuse_shared_files() knows them. Every
/// option that names a file has to be marked. Names that mean nothing are refused.
CLI::Option* mark_file(CLI::Option* option, FileRole role);
[[nodiscard]] std::optional<FileRole> file_role(const CLI::Option& option);

struct NamedFile {
  std::string option;  ///< As in the call, for messages.
  std::string name;
  FileRole role;
};

/// `; NAME is still the file of before` where a file that was to be written is there already, for
/// the end of a message that nothing is written. Empty for none, and for devices.
[[nodiscard]] std::string stale_note(const std::string& output);

/// Throws std::invalid_argument, naming both options, where an output is an input or another
/// output, under whatever name or link; also where standard output goes into such a file.
void refuse_shared_files(const std::vector<NamedFile>& files);

/// The same for the files of the commands that were called.
void refuse_shared_files(const CLI::App& app);

}  // namespace sim
