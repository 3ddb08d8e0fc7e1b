#pragma once

#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host-sim/cut/cut_report.hpp"
#include "host-sim/cut/edge_check.hpp"
#include "host-sim/job/setting_line.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// Where the programs of a job run: how they are written, and the machine as it is set.
struct CutRun {
  std::uint8_t decimals = 4;
  std::vector<SettingChange> settings{};
};

/// The program of a job, with its heading.
[[nodiscard]] std::string program_of(const cut::CutJob& job,
                                     const CutRun& run,
                                     const std::vector<std::string>& heading);

/// The faults that the machine finds in a program, and the time of the job.
struct ProgramCheck {
  std::vector<Fault> faults{};
  double job_time_s = 0.0;
  bool is_simulated = true;  ///< Else the time is the predicted one.
};

/// Looks the program over on the simulated machine, which has the job's kerf table; lines count as
/// in the program. A job of more than three hours, whose pulses take their time on this computer,
/// too, is read line by line in place of that: the same lines are refused, the same travel holds.
/// @param name what it is called in faults
[[nodiscard]] ProgramCheck check_program(const cut::CutJob& job,
                                         const CutRun& run,
                                         const std::vector<std::string>& heading,
                                         const std::string& name);

/// Returns the settings of the machine that programs of the run are made for.
[[nodiscard]] cnc::Settings settings_of(const CutRun& run);

/// The edges of a job, for programs, and those of its first way to be driven.
struct EdgeChecks {
  nlohmann::ordered_json rows{};
  cut::EdgeFigures first{};
};

/// Drives it and measures the edges, under power that follows the speed and under constant power
/// side by side; where the controller finds the way beside the parts, once with power that keeps
/// the kerf and once with a path that follows it. Tells people what came of it.
[[nodiscard]] EdgeChecks check_edges(const cut::CutJob& job, const CutRun& run, std::FILE* told);

}  // namespace sim
