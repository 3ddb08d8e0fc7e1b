#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/job_options.hpp"
#include "host-sim/report/duration_text.hpp"
#include "host-sim/report/report_json.hpp"
#include "host-sim/report/terminal.hpp"

namespace sim {
namespace {

/// Returns a text with the bounds of the axes from `first` up to, but not including, `last`; empty
/// if none of them moves.
std::string bounds_text(const Report& report, std::size_t first, std::size_t last) {
  std::string text;
  for (std::size_t axis = first; axis < last; ++axis) {
    const AxisReport& bounds = report.axes[axis];
    if (bounds.min_mm == bounds.greatest_mm) continue;
    text += fmt::format(
        "  {} {:.3f} to {:.3f}", cnc::kAxisLetters[axis], bounds.min_mm, bounds.greatest_mm);
  }
  return text;
}

void print(const Report& report) {
  const bool turns = report.turned_deg > 0.0;
  terminal::print("{}: {} lines, {}, {:.1f} mm, {:.1f} mm of it cut{}\n",
                  report.job,
                  report.lines,
                  duration_text(report.job_time_s),
                  report.path_length_mm,
                  report.cut_length_mm,
                  turns ? fmt::format(", {:.1f} degrees turned", report.turned_deg) : "");
  const std::string linear = bounds_text(report, 0, cnc::kLinearAxisCount);
  const std::string rotary = bounds_text(report, cnc::kLinearAxisCount, cnc::kAxisCount);
  if (!linear.empty() || rotary.empty()) {
    terminal::print("  bounds in mm:{}\n", linear.empty() ? "  no motion" : linear);
  }
  if (!rotary.empty()) terminal::print("  bounds in degrees:{}\n", rotary);
  for (const std::string& warning : report.warnings) terminal::print("  warning: {}\n", warning);
  for (const Fault& fault : report.faults) terminal::print("{}\n", to_string(fault));
}

nlohmann::ordered_json summary(const Report& report) {
  const nlohmann::ordered_json all = to_json(report);
  nlohmann::ordered_json picked;
  for (const char* key : {"job",
                          "version",
                          "job_time_s",
                          "path_length_mm",
                          "cut_length_mm",
                          "lines",
                          "refused_lines",
                          "blocks",
                          "bounds_mm",
                          "bounds_deg",
                          "warnings",
                          "faults"}) {
    picked[key] = all.at(key);
  }
  return picked;
}

ExitStatus check_all(const JobOptions& options) {
  const JobsDone done = for_each_job(options, check);
  const std::vector<Report>& reports = done.reports;
  if (options.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Report& report : reports) all.push_back(summary(report));
    terminal::write_data(dumped(all) + "\n");
  } else {
    for (const Report& report : reports) print(report);
  }
  return finish(done);
}

}  // namespace

void add_check_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command = app.add_subcommand(
      "check",
      "Check programs: time, bounds, travel, and every fault as file:line:column: message.");
  command->footer(
      "Examples:\n"
      "  kerfline check part.nc --settings laser.settings\n"
      "  kerfline check *.nc --json\n"
      "  cat part.nc | kerfline check -\n"
      "\n"
      "Exit status: 0 fine, 1 the program has faults, 2 the call is wrong.");
  const auto options = std::make_shared<JobOptions>();
  options->add_to(*command);
  command->callback([options, &status] { status = check_all(*options); });
}

}  // namespace sim
