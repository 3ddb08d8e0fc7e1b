#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/job/setting_line.hpp"
#include "host-sim/job/stock_run.hpp"
#include "host-sim/machine/simulator.hpp"
#include "host-sim/report/report.hpp"

namespace sim {

/// A program to run and the machine to run it on.
struct Job {
  std::string file;                   ///< Name of the file; `-` is standard input.
  std::optional<std::string> text{};  ///< Text of the program, if it is not in a file.
  std::vector<SettingChange> settings{};
  /// Model of the machine. It has no switches, because the position of the zero point of the
  /// program on the machine is not known.
  MachineModel machine{.has_switches = false};
  /// Function that is called with the share of the job that is done, 0…1.
  std::function<void(double)> on_progress{};
};

/// Names of the files to write while a job runs, and their options. A file with an empty name is
/// not written.
struct JobOutputs {
  std::string trace;
  std::string vcd;
  std::string svg;
  std::string png;
  /// File for the positions of the axes at short intervals of time (cells of the plan); see
  /// KnotFile.
  std::string knots;
  /// File for the lines that the controller sends, as in the log of a sender.
  std::string answers;
  /// Width of the kerf in pictures. If empty: 0.1 mm for a laser, and no kerf for a mill.
  std::optional<double> kerf_width_mm{};
  std::optional<StockWish> stock{};  ///< Stock to carve; empty if none is to be carved.
};

/// Sends a program to the simulated controller in the same way as a sender, measures the pulses and
/// writes the requested files. Sending ends at the first refused line. Throws std::invalid_argument
/// for a wrong setting, and std::system_error if a file cannot be read or written.
[[nodiscard]] Report simulate(const Job& job, const JobOutputs& outputs);

/// Checks a program without measuring its pulses. Computes its time and bounds, checks the travel,
/// and reports every line that has a fault. Throws the same exceptions as simulate().
[[nodiscard]] Report check(const Job& job);

}  // namespace sim
