#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/stock/stock_report.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// A refused line of a program.
struct Fault {
  std::string file;
  std::size_t line = 0;    ///< Number of the line, from 1.
  std::size_t column = 0;  ///< Column, from 1; 0 when the fault concerns the whole line.
  int number = 0;          ///< Grbl's error number.
  std::string message;
};

/// Returns `file:line:column: message` in the format of compilers, without a column if it is 0.
[[nodiscard]] std::string to_string(const Fault& fault);

/// Figures of one axis, measured on the trace; degrees instead of mm for A, B and C.
struct AxisReport {
  double max_speed_mm_s = 0.0;
  double max_acceleration_mm_s2 = 0.0;
  double max_jerk_mm_s3 = 0.0;
  /// Lower bound of the motion, machine coordinates; the upper bound follows.
  double min_mm = 0.0;
  double greatest_mm = 0.0;
  std::uint64_t steps = 0;  ///< Number of pulses in both directions.
  /// Possible errors of the figures above. They are read from steps: pulses share slots of time,
  /// and a motor rests on whole steps.
  double speed_error_mm_s = 0.0;
  double acceleration_error_mm_s2 = 0.0;
  double jerk_error_mm_s3 = 0.0;
  double bounds_error_mm = 0.0;
};

/// The machine that $900 to $917 describe.
struct FiveAxisMachine {
  std::string kind;  ///< Kind of the machine: `tables`, `heads` or `head and table`.
  char tilting = 'A';
  bool tilt_reversed = false;
  bool turn_reversed = false;
  std::array<double, 3> tilt_point_mm{};
  std::array<double, 3> turn_point_mm{};
  double min_tilt_deg = 0.0;
  double greatest_tilt_deg = 0.0;
};

/// Positions of the tip as the part saw it, under G43.4.
struct TipReport {
  std::array<double, 3> min_mm{};  ///< X Y Z, positions of the program.
  std::array<double, 3> greatest_mm{};
  double greatest_tilt_deg = 0.0;  ///< Greatest angle of the tool from upright.
  double tool_length_mm = 0.0;     ///< Length of the tool that was used last.
  FiveAxisMachine machine{};
};

/// Result of a run of one job (`--report FILE`, and the table on the terminal).
struct Report {
  std::string job;  ///< Name of the file, or `-`.
  double job_time_s = 0.0;
  double path_length_mm = 0.0;  ///< Length of all motion of X, Y and Z together.
  double turned_deg = 0.0;  ///< Angle turned in motions of A, B and C alone, as `check` reads them.
  double cut_length_mm = 0.0;  ///< Length driven with the beam or spindle on.
  std::size_t lines = 0;       ///< Number of lines read from the file.
  /// Number of these lines that were refused; they are part of no other figure.
  std::size_t refused_lines = 0;
  std::size_t blocks = 0;  ///< Number of path elements planned.
  cnc::AxisArray<AxisReport> axes{};
  /// Beam energy per mm divided by the energy that S and F require, in windows of 0.05 mm of the
  /// path; not a number where no beam was measured.
  double min_energy_ratio = std::numeric_limits<double>::quiet_NaN();
  double mean_energy_ratio = std::numeric_limits<double>::quiet_NaN();
  double greatest_energy_ratio = std::numeric_limits<double>::quiet_NaN();
  double max_path_deviation_mm = 0.0;    ///< Greatest distance from the programmed path.
  double max_path_deviation_at_s = 0.0;  ///< Time of that greatest distance.
  /// Greatest distance in mm by which input shaping took the tool off the planned path; 0 without a
  /// shaper.
  double max_shaping_error_mm = 0.0;
  std::optional<TipReport> tip{};             ///< Present if G43.4 was in use.
  std::optional<stock::StockReport> stock{};  ///< Present if a stock was carved.
  std::vector<std::string> warnings;
  std::vector<Fault> faults;
};

}  // namespace sim
