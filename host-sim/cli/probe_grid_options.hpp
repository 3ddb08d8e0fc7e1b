#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "host-sim/surface/probe_program.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline surface probe-grid`.
struct ProbeGridOptions {
  std::string x;  ///< X of the first and the last column, `FROM:TO` in mm.
  std::string y;
  std::optional<double> pitch_mm;
  std::optional<std::size_t> columns;
  std::optional<std::size_t> rows;
  std::optional<double> safe_mm;
  std::optional<double> depth_mm;
  std::optional<double> feed;
  std::optional<double> fast_feed;
  std::optional<double> hop_mm;
  double retract_mm = surface::ProbeProgram{}.retract_mm;
  double travel_feed = surface::ProbeProgram{}.travel_feed;
  std::optional<double> tip_mm;
  std::string read;  ///< Log with the answers to read; if empty, a program is written.
  /// File of the program that probed the points; its heading contains the options of the grid.
  std::string program;
  std::string offset;  ///< Work zero `X,Y,Z` in machine coordinates, mm; empty if not given.
  bool inches = false;
  bool gaps = false;
  std::string output;

  void add_to(CLI::App& command);

  // Return the grid and the program that the options describe. Each function throws
  // std::invalid_argument, which names the option.

  [[nodiscard]] surface::ProbeGrid grid() const;
  [[nodiscard]] surface::ProbeProgram probe_program() const;
  /// Returns the work zero of `--offset`; empty without that option.
  [[nodiscard]] std::optional<Eigen::Vector3d> work_zero() const;
};

}  // namespace sim
