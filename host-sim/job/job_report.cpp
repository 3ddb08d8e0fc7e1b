#include "host-sim/job/job_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "firmware/machine/configuration.hpp"
#include "host-sim/job/fault_place.hpp"
#include "host-sim/trace/input_file.hpp"
#include "planner/gcode/line_reader.hpp"

namespace sim {
namespace {

/// Grbl's error number for a line that is no G-code.
constexpr int kUnreadable = 1;

/// Greatest ratio of a set rate to the rate that the motor reaches at which the set rate counts as
/// reached.
constexpr double kNoLess = 1.001;

/// Returns whether a text consists only of blanks and control bytes, apart from a byte order mark
/// at its start.
bool has_no_text(std::string_view text) {
  return std::ranges::all_of(cnc::gcode::without_mark(text), [](char letter) {
    return static_cast<unsigned char>(letter) <= ' ' || letter == 0x7F;
  });
}

}  // namespace

std::string job_name(const std::string& file) {
  return file == "-" ? file : std::filesystem::path{file}.filename().string();
}

ProgramText prepared(const Job& job) {
  bool block_delete = true;
  for (const SettingChange& change : job.settings) {
    if (change.number == cnc::setting::kBlockDelete) block_delete = change.value != 0.0F;
  }
  std::string text = job.text ? *job.text : read_text(job.file);
  // An empty file usually results from a failed export, so it is an error and not a program that
  // takes no time.
  if (text.empty() && !job.text) {
    throw std::invalid_argument(fmt::format("{}: is empty; it has no program", job.file));
  }
  if (!job.text && has_no_text(text)) {
    throw std::invalid_argument(
        fmt::format("{}: has nothing but blanks; it has no program", job.file));
  }
  return prepare_program(std::move(text), block_delete);
}

double cut_length(const PathPiece& piece) {
  const bool cuts = piece.travel == Travel::kFeed && piece.spindle != SpindleState::kOff &&
                    piece.spindle_speed > 0.0;
  return cuts ? piece.curve.linear_length() : 0.0;
}

void warn_of_step_rates(const Job& job, const cnc::Settings& settings, Report& report) {
  if (job.settings.empty()) return;
  const cnc::motion::Limits limits = cnc::limits_from(settings);
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const double scale = limits.scale[axis].steps_per_mm();
    const double most = std::min(limits.steps_per_s_one_motor, limits.steps_per_s_all_motors);
    const double wanted = scale * limits.rate_mm_s[axis];
    if (wanted <= kNoLess * most) continue;
    report.warnings.push_back(
        fmt::format("{}: ${}={:g} is {:.0f} steps/s; pulses of $0={:g} us allow {:.0f}, so {} is "
                    "driven at {:.0f} {}/min at most",
                    job.file,
                    cnc::setting::kRate + axis,
                    settings.get(cnc::setting::kRate, axis),
                    wanted,
                    settings.get(cnc::setting::kStepPulse),
                    most,
                    cnc::kAxisLetters[axis],
                    most / scale * 60.0,
                    axis < cnc::kLinearAxisCount ? "mm" : "deg"));
  }
}

void warn(const Job& job, const std::vector<LineNote>& notes, Report& report) {
  for (const LineNote& note : notes) report.warnings.push_back(place_and_text(job.file, note));
}

void warn(const Job& job, const std::vector<ReadNote>& notes, Report& report) {
  for (const ReadNote& note : notes) {
    report.warnings.push_back(fmt::format("{}:{}: {}", job.file, note.line, note.text));
  }
}

Report report_on(const Job& job,
                 const ProgramText& program,
                 const RunResult& result,
                 const std::optional<RefusedBeside>& beside,
                 std::string_view text) {
  Report report;
  report.job = job_name(job.file);
  report.job_time_s = result.job_time_s;
  report.lines = result.lines;
  report.blocks = result.blocks;
  report.refused_lines = result.refused;
  warn(job, program.notes, report);
  for (const auto& [line, words] : result.notes) {
    report.warnings.push_back(fmt::format("{}:{}: {}", job.file, line, words));
  }
  for (const Refusal& refusal : result.refusals) {
    report.faults.push_back(fault_of(job.file, refusal, beside, text));
  }
  if (result.refused > result.refusals.size()) {
    report.warnings.push_back(
        fmt::format("{}: {} lines are refused, of which the first {} are listed",
                    job.file,
                    result.refused,
                    result.refusals.size()));
  }
  for (const LineNote& fault : program.faults) {
    // If the program is readable, the controller itself has refused the lines with wrong checks.
    if (program.readable) break;
    report.faults.push_back({job.file, fault.line, fault.column, kUnreadable, fault.text});
  }
  if (result.alarm != 0) {
    report.faults.push_back({job.file,
                             result.lines,
                             0,
                             result.alarm,
                             fmt::format("the machine stopped with alarm {}", result.alarm)});
  }
  return report;
}

}  // namespace sim
