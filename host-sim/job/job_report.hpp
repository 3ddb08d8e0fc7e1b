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

/// Returns the name of a file without its folders; `-` is standard input.
[[nodiscard]] std::string job_name(const std::string& file);

/// Returns the program of a job as it is driven. Throws std::system_error for the file.
[[nodiscard]] ProgramText prepared(const Job& job);

/// Returns the length in mm of a piece that is driven with beam or spindle on; 0 for any other
/// piece.
[[nodiscard]] double cut_length(const PathPiece& piece);

/// Begins the report of a run with name, time, lines, faults and the warnings of text and
/// controller.
/// @param beside see beside_path()
/// @param text the program as it was sent to the controller
[[nodiscard]] Report report_on(const Job& job,
                               const ProgramText& program,
                               const RunResult& result,
                               const std::optional<RefusedBeside>& beside,
                               std::string_view text);

/// Warns of each axis whose rate ($110 to $115) its motor does not reach, because the pulses ($0)
/// and the step interrupt leave too little time for the steps of that rate. Warns only if the job
/// names settings.
void warn_of_step_rates(const Job& job, const cnc::Settings& settings, Report& report);

void warn(const Job& job, const std::vector<LineNote>& notes, Report& report);
void warn(const Job& job, const std::vector<ReadNote>& notes, Report& report);

}  // namespace sim
