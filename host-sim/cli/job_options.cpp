#include "host-sim/cli/job_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <set>
#include <utility>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/machine_option.hpp"
#include "host-sim/cli/standard_streams.hpp"
#include "host-sim/report/progress_bar.hpp"
#include "host-sim/report/progress_lines.hpp"

namespace sim {

void JobOptions::add_to(CLI::App& command) {
  mark_file(command.add_option("FILE", files, "G-code programs; - is standard input")->required(),
            FileRole::kInput);
  add_machine_option(command, machine);
  mark_file(command
                .add_option("--settings",
                            settings_file,
                            "File of the machine's settings, `$N=value` on each line")
                ->type_name("FILE"),
            FileRole::kInput);
  command
      .add_option("--set",
                  set,
                  "One setting of the machine, such as '$110=12000' (mm/min); may be repeated")
      ->type_name("$N=V")
      ->allow_extra_args(false);
  probe.add_to(command);
  command.add_flag("--json", json, "Print the report as JSON");
  command.add_flag(
      "--progress", progress, "Print percent and time every 5 s if there is no terminal for a bar");
}

std::vector<SettingChange> settings_of(const std::string& machine,
                                       const std::string& file,
                                       const std::vector<std::string>& set) {
  std::vector<SettingChange> changes;
  if (auto profile = machine_profile_of(machine)) changes = std::move(profile->settings);
  if (!file.empty()) {
    const std::vector<SettingChange> more = read_settings_file(file);
    changes.insert(changes.end(), more.begin(), more.end());
  }
  for (const std::string& text : set) changes.push_back(parse_setting(text, "--set"));
  return changes;
}

JobsDone for_each_job(const JobOptions& options, const std::function<Report(const Job&)>& work) {
  using Clock = std::chrono::steady_clock;
  const std::vector<SettingChange> settings =
      settings_of(options.machine, options.settings_file, options.set);
  MachineModel machine{.has_switches = false};
  options.probe.apply(options.probe.read(), machine);
  JobsDone done;
  const bool on_terminal = is_terminal(stderr);
  ProgressBar bar{stderr, on_terminal, Clock::now()};
  for (const std::string& file : options.files) {
    ProgressLines lines{stderr, options.progress && !on_terminal, Clock::now()};
    const auto show = [&bar, &lines, &file](double share) {
      bar.update(share, file, Clock::now());
      lines.update(share, file, Clock::now());
    };
    Job job{.file = file, .settings = settings, .machine = machine, .on_progress = show};
    try {
      done.reports.push_back(work(job));
    } catch (const std::exception& error) {
      if (options.files.size() == 1 || standard_output_failed()) throw;
      done.errors.emplace_back(error.what());
    }
  }
  return done;
}

ExitStatus finish(const JobsDone& done) {
  // Errors that were printed: a wrong setting is an error of every file, and is printed once.
  std::set<std::string> printed;
  for (const std::string& error : done.errors) {
    if (printed.insert(error).second) print_error(error.c_str());
  }
  if (!done.errors.empty()) return ExitStatus::kUsage;
  return any_faults(done.reports) ? ExitStatus::kFaults : ExitStatus::kFine;
}

bool may_colour() {
  const char* no_colour = std::getenv("NO_COLOR");
  return is_terminal(stdout) && (no_colour == nullptr || *no_colour == '\0');
}

bool any_faults(const std::vector<Report>& reports) {
  return std::any_of(
      reports.begin(), reports.end(), [](const Report& report) { return !report.faults.empty(); });
}

}  // namespace sim
