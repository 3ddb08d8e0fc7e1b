#pragma once

#include <cstdio>
#include <span>
#include <string>

#include "host-sim/report/report.hpp"

namespace sim {

/// Returns the report as readable text: the facts of the job, a table of the axes that moved, the
/// warnings and the faults.
/// @param colour whether terminal colours are allowed; the caller decides by the terminal and
/// NO_COLOR
[[nodiscard]] std::string report_text(const Report& report, bool colour);

/// Returns a table with one row for each job: time, lengths, counts, greatest speed and
/// acceleration of X, Y and Z, deviation. The warnings and faults of all jobs follow below the
/// table.
[[nodiscard]] std::string summary_text(std::span<const Report> reports, bool colour);

/// Prints one job in full, or several jobs as a summary.
void print_table(std::FILE* stream, std::span<const Report> reports, bool colour);

}  // namespace sim
