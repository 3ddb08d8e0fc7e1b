#pragma once

#include <cstdio>
#include <nlohmann/json_fwd.hpp>

#include "host-sim/cli/cut_output_options.hpp"
#include "host-sim/cut/cut_report.hpp"
#include "host-sim/cut/edge_check.hpp"
#include "host-sim/cut/timeline.hpp"

namespace sim {

/// Writes the pictures that the options require.
/// @param edges measured edges; null if they were not measured
void write_pictures(const CutOutputOptions& options,
                    const cut::CutJob& job,
                    const cut::Timeline& timeline,
                    const cut::EdgeFigures* edges);

/// Prints the parts of the job's time and money, adds them to the report, and writes the files
/// about them that the options require.
/// @param job_time_s time of the job, see account_of()
void account_for(const CutOutputOptions& options,
                 const cut::CutJob& job,
                 const cut::Timeline& timeline,
                 double job_time_s,
                 std::FILE* told,
                 nlohmann::ordered_json& report);

}  // namespace sim
