#pragma once

#include <string>

#include "host-sim/contour/outline.hpp"
#include "host-sim/pocket/mill_program.hpp"
#include "planner/pocket/pocket_path.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): theirs.
class App;
}

namespace sim {

/// The options of `kerfline pocket`.
struct PocketCommandOptions {
  std::string file;
  std::string output;
  std::string report;
  std::string svg;
  OutlineOptions outline;
  double tool_mm = 0.0;
  double depth_mm = 0.0;
  double depth_step_mm = 0.0;  ///< 0: half the tool's diameter.
  double stepover_mm = 0.0;    ///< 0: as far as nothing is left.
  double corner_mm = -1.0;     ///< Negative: a tenth of the tool's radius.
  double slope_deg = 3.0;
  cnc::pocket::EntryKind entry = cnc::pocket::EntryKind::kHelix;
  bool conventional = false;
  bool anyway = false;
  pocket::MillSettings mill;
  unsigned decimals = 4;
};

/// Adds all of them, with their ranges, units and defaults.
void add_pocket_options(CLI::App& command, PocketCommandOptions& options);

/// The path that they ask for.
[[nodiscard]] cnc::pocket::PocketOptions<double> pocket_options_of(
    const PocketCommandOptions& options);

}  // namespace sim
