#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/cli/pocket_options.hpp"
#include "host-sim/job/program_digest.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim {

/// The path of all pockets of a drawing, and what is told of it.
struct MilledDrawing : pocket::PathRows {
  Contour walls;
  std::size_t pockets = 0;          ///< With a path.
  std::uint32_t levels = 0;         ///< The greatest number of levels of a pocket.
  std::uint32_t passes = 0;         ///< Number of passes, loops or lines of each level.
  std::vector<double> floors_mm{};  ///< Depths of all floors, increasing; not of V carving.
  std::uint32_t links = 0;
  std::vector<pocket::NarrowStretch> narrow;
  double carved_depth_mm = 0.0;          ///< The greatest, of V carving.
  std::vector<ProgramDigest> digests{};  ///< Of the files that it was made from.
  double wide_area_mm2 = 0.0;  ///< Area that is too wide for a V tool at the greatest depth.
};

/// Lines of comment for the top of the program.
[[nodiscard]] std::vector<std::string> pocket_heading(const PocketCommandOptions& options,
                                                      const MilledDrawing& milled);

/// The same for the program that drills holes for it.
[[nodiscard]] std::vector<std::string> holes_heading(const PocketCommandOptions& options,
                                                     const MilledDrawing& milled);

/// One line for the terminal.
[[nodiscard]] std::string pocket_summary(const PocketCommandOptions& options,
                                         const MilledDrawing& milled);

/// Figures as JSON, for --report.
[[nodiscard]] std::string pocket_report(const PocketCommandOptions& options,
                                        const MilledDrawing& milled);

}  // namespace sim
