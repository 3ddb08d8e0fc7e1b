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
  std::size_t column = 0;  ///< Column, from 1; 0 if the fault concerns the complete line.
  int number = 0;          ///< Grbl's error number.
  std::string message;
};

/// Returns `file:line:column: message` in the format of compilers. The column is omitted if it is
/// 0.
[[nodiscard]] std::string to_string(const Fault& fault);

/// Figures of one axis, measured on the trace. For A, B and C, degrees replace mm.
struct AxisReport {
  double max_speed_mm_s = 0.0;
  double max_acceleration_mm_s2 = 0.0;
  double max_jerk_mm_s3 = 0.0;
  /// Least position of the axis, in machine coordinates.
  double min_mm = 0.0;
  double greatest_mm = 0.0;
  std::uint64_t steps = 0;  ///< Number of pulses in both directions.
  /// Greatest possible errors of the figures above. The figures have errors because they are
  /// computed from steps: pulses share time slots, and a motor rests on full steps.
  double speed_error_mm_s = 0.0;
  double acceleration_error_mm_s2 = 0.0;
  double jerk_error_mm_s3 = 0.0;
  double bounds_error_mm = 0.0;
};

/// The machine that the settings $900 to $917 describe.
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

/// Positions of the tip relative to the part, under G43.4.
struct TipReport {
  std::array<double, 3> min_mm{};  ///< Least X, Y and Z, in the coordinates of the program.
  std::array<double, 3> greatest_mm{};
  double greatest_tilt_deg = 0.0;  ///< Greatest angle between the tool and the vertical.
  double tool_length_mm = 0.0;     ///< Length of the last tool that was used.
  FiveAxisMachine machine{};
};

/// Result of the run of one job (`--report FILE`, and the table on the terminal).
struct Report {
  std::string job;  ///< Name of the file, or `-`.
  double job_time_s = 0.0;
  double path_length_mm = 0.0;  ///< Length of all motion of X, Y and Z.
  /// Angle of the motions in which only A, B or C turn, as `check` reads them.
  double turned_deg = 0.0;
  double cut_length_mm = 0.0;  ///< Length with the beam or the spindle on.
  std::size_t lines = 0;       ///< Number of lines in the file.
  /// Number of refused lines. All other figures exclude them.
  std::size_t refused_lines = 0;
  std::size_t blocks = 0;  ///< Number of planned path elements.
  cnc::AxisArray<AxisReport> axes{};
  /// Beam energy per mm divided by the energy per mm that S and F require, in windows of 0.05 mm
  /// along the path. Not a number if no beam was measured.
  double min_energy_ratio = std::numeric_limits<double>::quiet_NaN();
  double mean_energy_ratio = std::numeric_limits<double>::quiet_NaN();
  double greatest_energy_ratio = std::numeric_limits<double>::quiet_NaN();
  double max_path_deviation_mm = 0.0;    ///< Greatest distance from the programmed path.
  double max_path_deviation_at_s = 0.0;  ///< Time of max_path_deviation_mm.
  /// Greatest distance by which input shaping moved the tool from the planned path; 0 without a
  /// shaper.
  double max_shaping_error_mm = 0.0;
  std::optional<TipReport> tip{};             ///< Present if G43.4 was in use.
  std::optional<stock::StockReport> stock{};  ///< Present if a stock was carved.
  std::vector<std::string> warnings;
  std::vector<Fault> faults;
};

}  // namespace sim
