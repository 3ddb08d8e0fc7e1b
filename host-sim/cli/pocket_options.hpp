#pragma once

#include <string>

#include "host-sim/contour/outline.hpp"
#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/pocket/strategy.hpp"
#include "host-sim/pocket/v_carving.hpp"

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
  pocket::Strategy strategy = pocket::Strategy::kContour;
  double engagement_deg = 60.0;
  bool keeps_feed = false;   ///< Where chips are thin, too.
  double finish_mm = 0.0;    ///< 0: no passes of their own along the walls.
  double v_angle_deg = 0.0;  ///< 0: no V carving.
  bool anyway = false;
  pocket::MillSettings mill;
  unsigned decimals = 4;

  [[nodiscard]] double radius_mm() const { return 0.5 * tool_mm; }
  [[nodiscard]] bool is_v_carving() const { return v_angle_deg > 0.0; }
};

/// Adds all of them, with their ranges, units and defaults.
void add_pocket_options(CLI::App& command, PocketCommandOptions& options);

/// Throws std::invalid_argument for options that the strategy does not have.
void check_pocket_options(const CLI::App& command, const PocketCommandOptions& options);

/// How they ask for pockets to be milled.
[[nodiscard]] pocket::StrategyOptions strategy_options_of(const PocketCommandOptions& options);

/// How they ask for areas to be carved: as deep as they and the tool allow.
[[nodiscard]] pocket::VCarveOptions carve_options_of(const PocketCommandOptions& options);

/// How they ask for the machine to be driven.
[[nodiscard]] pocket::MillSettings mill_settings_of(const PocketCommandOptions& options);

}  // namespace sim
