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

/// Form of the programs of a job, and the machine with its settings.
struct CutRun {
  std::uint8_t decimals = 4;
  std::vector<SettingChange> settings{};
};

/// Returns the program of a job, with its heading.
[[nodiscard]] std::string program_of(const cut::CutJob& job,
                                     const CutRun& run,
                                     const std::vector<std::string>& heading);

/// Faults that the machine finds in a program, and the time of the job.
struct ProgramCheck {
  std::vector<Fault> faults{};
  double job_time_s = 0.0;
  bool is_simulated = true;  ///< Whether the time is simulated; otherwise it is predicted.
};

/// Checks the program on the simulated machine, which has the job's kerf table. Line numbers are
/// those of the program. A job of more than three hours is read line by line instead, because
/// simulating its pulses takes long: the reader refuses the same lines and applies the same travel.
/// @param name name of the program in faults
[[nodiscard]] ProgramCheck check_program(const cut::CutJob& job,
                                         const CutRun& run,
                                         const std::vector<std::string>& heading,
                                         const std::string& name);

/// Returns the settings of the machine for which programs of the run are made.
[[nodiscard]] cnc::Settings settings_of(const CutRun& run);

/// Measured edges of a job. It is driven in several variants, each of which has a row for the
/// report.
struct EdgeChecks {
  nlohmann::ordered_json rows{};
  cut::EdgeFigures first{};
};

/// Simulates the job and measures the edges, once with power that follows the speed and once with
/// constant power. If the controller offsets the path by the kerf, drives the job once with power
/// that keeps the kerf constant and once with a path that follows the changing kerf. Prints the
/// results to `told`.
[[nodiscard]] EdgeChecks check_edges(const cut::CutJob& job, const CutRun& run, std::FILE* told);

}  // namespace sim
