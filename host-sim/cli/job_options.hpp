#pragma once

#include <functional>
#include <string>
#include <vector>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/probe_options.hpp"
#include "host-sim/job/job.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options that all commands on programs share.
struct JobOptions {
  std::vector<std::string> files;
  std::string machine;  ///< File, or name of a shipped profile; empty for none.
  std::string settings_file;
  std::vector<std::string> set;
  ProbeOptions probe;
  bool json = false;
  bool progress = false;

  void add_to(CLI::App& command);
};

/// Returns the settings of a call in the order in which they apply: those of the machine profile,
/// those of the settings file, then `--set` in the order of the call. Throws std::invalid_argument
/// and std::system_error.
/// @param machine file or name of a profile, empty for none
/// @param file file of `$N=value` lines, empty for none
[[nodiscard]] std::vector<SettingChange> settings_of(const std::string& machine,
                                                     const std::string& file,
                                                     const std::vector<std::string>& set);

/// Reports of the files of a call, and errors of the files without a report.
struct JobsDone {
  std::vector<Report> reports;
  std::vector<std::string> errors;
};

/// Runs `work` on every file, with a progress bar on a terminal, or with progress lines if
/// `progress` requires them. A file that cannot be read does not prevent the reports of other
/// files; if it is the only file, the function throws.
[[nodiscard]] JobsDone for_each_job(const JobOptions& options,
                                    const std::function<Report(const Job&)>& work);

/// Prints the errors after the reports, and returns the status of the call.
[[nodiscard]] ExitStatus finish(const JobsDone& done);

/// Returns whether standard output may be coloured: it is a terminal, and NO_COLOR is not set.
[[nodiscard]] bool may_colour();

[[nodiscard]] bool any_faults(const std::vector<Report>& reports);

}  // namespace sim
