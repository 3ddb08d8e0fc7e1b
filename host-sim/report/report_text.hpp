#pragma once

#include <cstdio>
#include <span>
#include <string>

#include "host-sim/report/report.hpp"

namespace sim {

/// The report for people: what the job was, a table of its axes (those that
/// moved), its warnings and faults. `colour` allows terminal colours; the caller
/// decides by terminal and NO_COLOR.
[[nodiscard]] std::string report_text(const Report& report, bool colour);

/// One row for each job: time, lengths, counts, greatest speed and acceleration
/// of any of X, Y and Z, deviation; below it the warnings and faults of all.
[[nodiscard]] std::string summary_text(std::span<const Report> reports, bool colour);

/// One job in full, several as a summary.
void print_table(std::FILE* stream, std::span<const Report> reports, bool colour);

}  // namespace sim
