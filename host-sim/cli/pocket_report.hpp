#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/cli/pocket_options.hpp"
#include "host-sim/job/program_digest.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim {

/// Path of all pockets of a drawing, with the figures for its report.
struct MilledDrawing : pocket::PathRows {
  Contour walls;
  std::size_t pockets = 0;          ///< Number of pockets with a path.
  std::uint32_t levels = 0;         ///< Greatest number of levels of any pocket.
  std::uint32_t passes = 0;         ///< Number of passes, loops or lines in each level.
  std::vector<double> floors_mm{};  ///< Depths of all floors, increasing; empty for V carving.
  std::uint32_t links = 0;
  std::vector<pocket::NarrowStretch> narrow;
  double carved_depth_mm = 0.0;          ///< Greatest depth of V carving.
  std::vector<ProgramDigest> digests{};  ///< Digests of the files from which the path was made.
  double wide_area_mm2 = 0.0;  ///< Area that is too wide for a V tool at the greatest depth.
};

/// Returns the comment lines for the top of the program.
[[nodiscard]] std::vector<std::string> pocket_heading(const PocketCommandOptions& options,
                                                      const MilledDrawing& milled);

/// Returns the comment lines for the top of the program that drills the holes.
[[nodiscard]] std::vector<std::string> holes_heading(const PocketCommandOptions& options,
                                                     const MilledDrawing& milled);

/// Returns one line for the terminal.
[[nodiscard]] std::string pocket_summary(const PocketCommandOptions& options,
                                         const MilledDrawing& milled);

/// Returns the figures as JSON, for --report.
[[nodiscard]] std::string pocket_report(const PocketCommandOptions& options,
                                        const MilledDrawing& milled);

}  // namespace sim
