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
  std::optional<std::string> text{};  ///< The program itself, if it is not in a file.
  std::vector<SettingChange> settings{};
  /// The model has no switches, because the position of the program's zero on the machine is not
  /// known.
  MachineModel machine{.has_switches = false};
  std::function<void(double)> on_progress{};  ///< Called with the share done, 0…1.
};

/// Files to write while a job runs; empty names are not written.
struct JobOutputs {
  std::string trace;
  std::string vcd;
  std::string svg;
  std::string png;
  std::string knots;    ///< Positions of the axes at the ends of cells; see KnotFile.
  std::string answers;  ///< Lines that the controller sends, as a sender logs them.
  /// Width of the kerf in pictures. If empty: 0.1 mm for a laser, and no kerf for a mill.
  std::optional<double> kerf_width_mm{};
  std::optional<StockWish> stock{};  ///< Stock to carve.
};

/// Runs a job through the simulated controller as a sender would, measures its pulses and writes
/// the requested files. Sending ends at the first refused line. Throws std::invalid_argument for a
/// bad setting, std::system_error for files.
[[nodiscard]] Report simulate(const Job& job, const JobOutputs& outputs);

/// Checks a program without measuring its pulses: time, bounds, travel, and every fault of every
/// line. Throws as simulate() does.
[[nodiscard]] Report check(const Job& job);

}  // namespace sim
