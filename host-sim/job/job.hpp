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
  std::string file;                   ///< `-` is standard input.
  std::optional<std::string> text{};  ///< The program itself, where no file has it.
  std::vector<SettingChange> settings{};
  /// Without switches: where on the machine the program's zero lies is not known.
  MachineModel machine{.has_switches = false};
  std::function<void(double)> on_progress{};  ///< Share done, 0…1.
};

/// Files to write while a job runs; empty names are not written.
struct JobOutputs {
  std::string trace;
  std::string vcd;
  std::string svg;
  std::string png;
  std::string knots;    ///< Places of the axes by cells of time; see KnotFile.
  std::string answers;  ///< Lines of the controller, as a sender logs them.
  /// In pictures; without a number 0.1 mm, and none of a mill.
  std::optional<double> kerf_width_mm{};
  std::optional<StockWish> stock{};  ///< To carve.
};

/// Runs a job through the simulated controller as a sender would, measures its
/// pulses and writes what is asked for. Sending ends at the first refused line.
/// Throws std::invalid_argument for a bad setting, std::system_error for files.
[[nodiscard]] Report simulate(const Job& job, const JobOutputs& outputs);

/// Looks a program over without watching its pulses: time, bounds, travel, and
/// every fault of every line. Throws as simulate() does.
[[nodiscard]] Report check(const Job& job);

}  // namespace sim
