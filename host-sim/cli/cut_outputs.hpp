#pragma once

#include <cstdio>
#include <nlohmann/json_fwd.hpp>

#include "host-sim/cli/cut_output_options.hpp"
#include "host-sim/cut/cut_report.hpp"
#include "host-sim/cut/edge_check.hpp"
#include "host-sim/cut/timeline.hpp"

namespace sim {

/// Writes the picture where one is asked for. @param edges null where they were not measured
void write_pictures(const CutOutputOptions& options,
                    const cut::CutJob& job,
                    const cut::Timeline& timeline,
                    const cut::EdgeFigures* edges);

/// Prints what time and money of the job go to, adds it to the report, and writes the files that
/// show it where they are asked for.
/// @param job_time_s as account_of()
void account_for(const CutOutputOptions& options,
                 const cut::CutJob& job,
                 const cut::Timeline& timeline,
                 double job_time_s,
                 std::FILE* told,
                 nlohmann::ordered_json& report);

}  // namespace sim
