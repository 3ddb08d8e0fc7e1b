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
  std::size_t line = 0;    ///< From 1.
  std::size_t column = 0;  ///< From 1; 0 when the whole line is meant.
  int number = 0;          ///< Grbl's error number.
  std::string message;
};

/// `file:line:column: message`, as compilers say it; no column when it is 0.
[[nodiscard]] std::string to_string(const Fault& fault);

/// One axis as measured on the trace. In degrees instead of mm for A, B and C.
struct AxisReport {
  double max_speed_mm_s = 0.0;
  double max_acceleration_mm_s2 = 0.0;
  double max_jerk_mm_s3 = 0.0;
  double least_mm = 0.0;  ///< The bounds of the motion, machine coordinates.
  double greatest_mm = 0.0;
  std::uint64_t steps = 0;  ///< Pulses in both directions.
  /// By how much the figures above may be off because they are read from steps: pulses share slots
  /// of time, and a motor stands on whole steps.
  double speed_error_mm_s = 0.0;
  double acceleration_error_mm_s2 = 0.0;
  double jerk_error_mm_s3 = 0.0;
  double bounds_error_mm = 0.0;
};

/// The machine that $900 to $917 describe.
struct FiveAxisMachine {
  std::string kind;  ///< `tables`, `heads` or `head and table`.
  char tilting = 'A';
  bool tilt_reversed = false;
  bool turn_reversed = false;
  std::array<double, 3> tilt_point_mm{};
  std::array<double, 3> turn_point_mm{};
  double least_tilt_deg = 0.0;
  double greatest_tilt_deg = 0.0;
};

/// Where the tip was as the part saw it, under G43.4.
struct TipReport {
  std::array<double, 3> least_mm{};  ///< X Y Z, places of the program.
  std::array<double, 3> greatest_mm{};
  double greatest_tilt_deg = 0.0;  ///< From upright.
  double tool_length_mm = 0.0;     ///< Of the tool used last.
  FiveAxisMachine machine{};
};

/// What a run of one job was like (`--report FILE`, and the table on the terminal).
struct Report {
  std::string job;  ///< Name of the file, or `-`.
  double job_time_s = 0.0;
  double path_length_mm = 0.0;    ///< All motion, X, Y and Z together.
  double turned_deg = 0.0;        ///< By motions of A, B and C alone, as `check` reads them.
  double cut_length_mm = 0.0;     ///< With the beam or spindle on.
  std::size_t lines = 0;          ///< Read from the file.
  std::size_t refused_lines = 0;  ///< Of them; no figure counts them.
  std::size_t blocks = 0;         ///< Path elements planned.
  cnc::AxisArray<AxisReport> axes{};
  /// Beam energy per mm over what S and F ask for, in windows of 0.05 mm of the
  /// path; not a number where no beam was measured.
  double least_energy_ratio = std::numeric_limits<double>::quiet_NaN();
  double mean_energy_ratio = std::numeric_limits<double>::quiet_NaN();
  double greatest_energy_ratio = std::numeric_limits<double>::quiet_NaN();
  double max_path_deviation_mm = 0.0;    ///< Greatest distance from the programmed path…
  double max_path_deviation_at_s = 0.0;  ///< …and when.
  /// How far input shaping took the tool from the planned path, mm; 0 without a shaper.
  double max_shaping_error_mm = 0.0;
  std::optional<TipReport> tip{};             ///< If G43.4 was in use.
  std::optional<stock::StockReport> stock{};  ///< If one was carved.
  std::vector<std::string> warnings;
  std::vector<Fault> faults;
};

}  // namespace sim
