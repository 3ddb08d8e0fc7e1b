#include "host-sim/cli/file_options.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "hal/host/replacing_file.hpp"

namespace sim {
namespace {

constexpr std::array<std::pair<FileRole, const char*>, 3> kMarks{{
    {FileRole::kInput, "input file"},
    {FileRole::kOutput, "output file"},
    {FileRole::kKept, "kept file"},
}};

constexpr const char* kStandardInput = "-";

std::string identity_of(const struct ::stat& file) {
  return fmt::format("{}:{}", file.st_dev, file.st_ino);
}

/// Returns the identity of a file, which is the same for all its names. It is empty for a target to
/// which several outputs may be written, such as a device.
std::string identity_of(const std::string& name) {
  struct ::stat found {};
  if (name == kStandardInput) {
    const bool is_file = ::fstat(STDIN_FILENO, &found) == 0 && S_ISREG(found.st_mode);
    return is_file ? identity_of(found) : name;
  }
  for (const char* own : {"/dev/stdout", "/dev/stderr", "/dev/fd/", "/proc/self/fd/"}) {
    if (name.starts_with(own)) return {};
  }
  if (::stat(name.c_str(), &found) == 0) return S_ISREG(found.st_mode) ? identity_of(found) : "";
  std::error_code is_none;
  const std::filesystem::path target{hal::host::without_links(name)};
  const std::filesystem::path folder =
      std::filesystem::weakly_canonical(std::filesystem::absolute(target).parent_path(), is_none);
  return (folder / target.filename()).string();
}

/// Returns the identity of standard output if it goes into a file. No other file of the call may
/// have this identity.
std::optional<std::string> identity_of_standard_output() {
  struct ::stat found {};
  const bool is_file = ::fstat(STDOUT_FILENO, &found) == 0 && S_ISREG(found.st_mode);
  return is_file ? std::optional{identity_of(found)} : std::nullopt;
}

bool may_share(const NamedFile& a, const NamedFile& b) {
  return a.role == FileRole::kInput && b.role == FileRole::kInput && a.name != kStandardInput;
}

void add_files(const CLI::App& app, std::vector<NamedFile>& files) {
  for (const CLI::Option* option : app.get_options()) {
    const auto role = file_role(*option);
    if (!role) continue;
    for (const std::string& name : option->results()) {
      files.push_back({option->get_name(), name, *role});
    }
  }
}

}  // namespace

CLI::Option* mark_file(CLI::Option* option, FileRole role) {
  const auto check = [role](const std::string& name) -> std::string {
    if (name.empty()) return "the name of a file is missing";
    if (role == FileRole::kInput || name != kStandardInput) return {};
    return "`-` is standard input; write `./-` for a file of that name, /dev/stdout for the output";
  };
  for (const auto& [marked, mark] : kMarks) {
    if (marked == role) option->check(CLI::Validator{check, "", mark});
  }
  return option;
}

std::optional<FileRole> file_role(const CLI::Option& option) {
  for (const auto& [role, mark] : kMarks) {
    try {
      // CLI11 does not declare get_validator() const, although the function changes nothing.
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast)
      if (const_cast<CLI::Option&>(option).get_validator(mark) != nullptr) return role;
    } catch (const CLI::OptionNotFound&) {
      continue;
    }
  }
  return std::nullopt;
}

std::string stale_note(const std::string& output) {
  std::error_code is_none;
  if (output.empty() || !std::filesystem::is_regular_file(output, is_none)) return {};
  return fmt::format("; {} is still the earlier file", output);
}

void refuse_shared_files(const std::vector<NamedFile>& files) {
  const auto refuse = [](const NamedFile& file, const std::string& other) {
    throw std::invalid_argument(fmt::format(
        "{} {}: is the same file as {}; name another one", file.option, file.name, other));
  };
  std::vector<std::string> identities;
  const auto output = identity_of_standard_output();
  for (const NamedFile& file : files) {
    identities.push_back(identity_of(file.name));
    const std::string& identity = identities.back();
    if (identity.empty()) continue;
    if (identity == output) refuse(file, "standard output");
    for (std::size_t i = 0; i + 1 < identities.size(); ++i) {
      if (identities[i] != identity || may_share(files[i], file)) continue;
      refuse(file, fmt::format("{} {}", files[i].option, files[i].name));
    }
  }
}

void refuse_shared_files(const CLI::App& app) {
  std::vector<NamedFile> files;
  std::vector<const CLI::App*> open{&app};
  while (!open.empty()) {
    const CLI::App* command = open.back();
    open.pop_back();
    add_files(*command, files);
    const auto is_group = [](const CLI::App* below) { return below->get_name().empty(); };
    for (const CLI::App* group : command->get_subcommands(is_group)) open.push_back(group);
    for (const CLI::App* below : command->get_subcommands()) open.push_back(below);
  }
  refuse_shared_files(files);
}

}  // namespace sim
