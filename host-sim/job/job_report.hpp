#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host-sim/job/job.hpp"
#include "host-sim/job/program_text.hpp"
#include "host-sim/machine/simulator.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Returns the name of a file without its folders, for a report. The name `-` stands for standard
/// input.
[[nodiscard]] std::string job_name(const std::string& file);

/// Returns the program of a job, prepared by prepare_program(). Throws std::system_error if the
/// file cannot be read.
[[nodiscard]] ProgramText prepared(const Job& job);

/// Returns the length in mm of a piece that is driven with beam or spindle on; 0 for any other
/// piece.
[[nodiscard]] double cut_length(const PathPiece& piece);

/// Returns the first part of the report of a run: name, time, lines, faults, and the warnings of
/// the text and of the controller.
/// @param beside motion whose offset path could not be driven, if there is one; see beside_path()
/// @param text the program as it was sent to the controller
[[nodiscard]] Report report_on(const Job& job,
                               const ProgramText& program,
                               const RunResult& result,
                               const std::optional<RefusedBeside>& beside,
                               std::string_view text);

/// Adds a warning for each axis whose motor does not reach its rate ($110 to $115). The reason is
/// that the step pulses ($0) and the step interrupt take too much time for this step rate. Adds no
/// warnings if the job names no settings.
void warn_of_step_rates(const Job& job, const cnc::Settings& settings, Report& report);

void warn(const Job& job, const std::vector<LineNote>& notes, Report& report);
void warn(const Job& job, const std::vector<ReadNote>& notes, Report& report);

}  // namespace sim
