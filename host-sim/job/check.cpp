#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "firmware/machine/rest_light.hpp"
#include "host-sim/job/job.hpp"
#include "host-sim/job/job_report.hpp"
#include "host-sim/job/judged_path.hpp"
#include "host-sim/job/program_digest.hpp"
#include "host-sim/job/program_watch.hpp"

namespace sim {
namespace {

/// Reads each line of the program that the controller accepts, and computes the figures of the
/// path. The path itself is not stored.
class CheckedPath {
 public:
  explicit CheckedPath(const cnc::Settings& settings)
      : watch_{settings}, path_{standpoint_of(settings), [this](const PathPiece& piece) {
                                  put(piece);
                                }} {}

  void take(std::size_t line, std::string_view text) {
    watch_.take(line, text);
    path_.take(line, text);
  }

  /// Ends the program: no more lines follow.
  void end() {
    path_.end();
    watch_.end();
  }

  [[nodiscard]] const std::optional<RefusedBeside>& refused() const { return path_.refused(); }
  [[nodiscard]] bool notes_light_at_rest() const { return watch_.notes_light_at_rest(); }

  void add_to(const Job& job, std::string_view text, Report& report) const {
    report.path_length_mm = length_;
    report.turned_deg = turned_;
    report.cut_length_mm = cut_length_;
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      report.axes[axis].min_mm = path_.travel().bounds().low[axis];
      report.axes[axis].greatest_mm = path_.travel().bounds().high[axis];
    }
    warn(job, watch_.notes(), report);
    warn(job, path_.notes(), report);
    const auto overruns = path_.travel().faults(job.file, text);
    report.faults.insert(report.faults.end(), overruns.begin(), overruns.end());
  }

 private:
  void put(const PathPiece& piece) {
    length_ += piece.curve.linear_length();
    if (piece.curve.linear_length() == 0.0) turned_ += piece.curve.length();
    cut_length_ += cut_length(piece);
    watch_.put(piece);
  }

  double length_ = 0.0;
  /// Sum of the angles of motions of A, B and C without X, Y and Z, degrees.
  double turned_ = 0.0;
  double cut_length_ = 0.0;
  ProgramWatch watch_;
  JudgedPath path_;
};

/// Compares the settings only if the job names settings. Otherwise the simulated machine has
/// default settings, which may differ from those of every real machine.
void warn_of_stale_inputs(const Job& job, const Simulator& simulator, Report& report) {
  const cnc::Settings* const settings = job.settings.empty() ? nullptr : &simulator.settings();
  for (const std::string& text :
       stale_inputs(simulator.program(), folder_of(job.file), DigestFiles::kAny, settings)) {
    report.warnings.push_back(fmt::format("{}: {}", job.file, text));
  }
}

}  // namespace

Report check(const Job& job) {
  ProgramText program = prepared(job);
  std::optional<CheckedPath> path;
  Simulator simulator{
      std::move(program.text),
      {.after_refusal = AfterRefusal::kGoOn,
       .machine = job.machine,
       .watches_memory = false,
       .on_progress = job.on_progress,
       .on_taken = [&path](std::size_t line, std::string_view text) { path->take(line, text); }}};
  apply_settings(job.settings, simulator.machine());
  path.emplace(simulator.settings());
  RunResult result = simulator.run();
  path->end();
  // The controller reports light at rest only once. Its note is removed, because ProgramWatch
  // reports each occurrence in more detail.
  if (path->notes_light_at_rest()) {
    std::erase_if(result.notes,
                  [](const auto& note) { return note.second == cnc::RestLight::kRefusalText; });
  }
  Report report = report_on(job, program, result, path->refused(), simulator.program());
  path->add_to(job, simulator.program(), report);
  warn_of_step_rates(job, simulator.settings(), report);
  if (!job.text) warn_of_stale_inputs(job, simulator, report);
  if (report.refused_lines > 0) {
    report.warnings.push_back(
        fmt::format("{}: bounds, length and time do not include {} refused line{}",
                    job.file,
                    report.refused_lines,
                    report.refused_lines == 1 ? "" : "s"));
  }
  std::stable_sort(report.faults.begin(), report.faults.end(), [](const Fault& a, const Fault& b) {
    return a.line < b.line;
  });
  return report;
}

}  // namespace sim
