#include "host-sim/cli/machine_option.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/report/nearest_name.hpp"
#include "host-sim/trace/input_file.hpp"

namespace sim {
namespace {

namespace fs = std::filesystem;

/// Returns the folder of the shipped profiles, by its path relative to the installed program.
fs::path shipped_folder() {
  std::error_code is_none;
  const fs::path program = fs::read_symlink("/proc/self/exe", is_none);
  return program.parent_path().parent_path() / "share" / "kerfline" / "machines";
}

std::vector<std::string> shipped_names() {
  std::vector<std::string> names;
  std::error_code is_none;
  for (const fs::directory_entry& entry : fs::directory_iterator{shipped_folder(), is_none}) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

/// Returns the file of a profile from the name of the file or of a shipped profile.
std::string profile_file(const std::string& name) {
  const fs::path path{name};
  if (path.has_parent_path() || path.has_extension()) return name;
  const std::vector<std::string> names = shipped_names();
  if (std::ranges::find(names, name) != names.end()) {
    return (shipped_folder() / (name + ".json")).string();
  }
  throw std::invalid_argument(fmt::format(
      "--machine {}: no such profile is shipped; choose {}, or name a file, such as mine.json{}",
      name,
      fmt::join(names, ", "),
      did_you_mean(name, names)));
}

}  // namespace

void add_machine_option(CLI::App& command, std::string& machine) {
  mark_file(command
                .add_option("--machine",
                            machine,
                            "Profile of the machine, its bed, power and settings: a file, or k40, "
                            "diode-5w, diode-20w, router, sheet-cutter")
                ->type_name("NAME"),
            FileRole::kInput);
}

std::optional<cut::MachineProfile> machine_profile_of(const std::string& machine) {
  if (machine.empty()) return std::nullopt;
  const std::string file = profile_file(machine);
  const std::string name = file == machine ? name_of_input(file) : machine;
  return cut::read_machine_profile(read_text(file), name);
}

}  // namespace sim
