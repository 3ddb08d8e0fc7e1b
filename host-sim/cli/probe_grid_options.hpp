#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "host-sim/surface/probe_program.hpp"

namespace CLI {
class App;
}

namespace sim {

/// The options of `kerfline surface probe-grid`.
struct ProbeGridOptions {
  std::string x;  ///< `FROM:TO`.
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
  std::string read;     ///< Log with answers; empty: a program is written.
  std::string program;  ///< Whose heading says what was probed.
  std::string offset;   ///< `X,Y,Z`.
  bool inches = false;
  bool gaps = false;
  std::string output;

  void add_to(CLI::App& command);

  // Each throws std::invalid_argument, which names the option.

  [[nodiscard]] surface::ProbeGrid grid() const;
  [[nodiscard]] surface::ProbeProgram probe_program() const;
  /// Returns the work zero of `--offset`; nothing without one.
  [[nodiscard]] std::optional<Eigen::Vector3d> work_zero() const;
};

}  // namespace sim
