#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/cli/input_files.hpp"
#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/row_path.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): theirs.
class App;
}

namespace sim {

/// Where the tool is in relation to a boundary that it reaches.
enum class BoundarySide : std::uint8_t {
  kInside,   ///< Its rim stays inside.
  kOn,       ///< Its tip ends on the line.
  kOutside,  ///< Its rim goes just beyond.
};

/// The options of `kerfline surface` that say where rows go.
struct RegionOptions {
  std::string boundary;  ///< A drawing; empty: none.
  BoundarySide side = BoundarySide::kOn;
  std::string slope;    ///< `LOW:HIGH` in degrees; empty: any.
  std::string rest_of;  ///< The larger tool; empty: none.
  double rest_allowance_mm = 0.0;
  double rest_depth_mm = 0.0;  ///< 0: three tolerances, at least 0.02 mm.

  [[nodiscard]] bool any() const { return !boundary.empty() || !slope.empty() || !rest_of.empty(); }
};

/// Adds all of them, with their ranges, units and defaults.
void add_region_options(CLI::App& command, RegionOptions& options);

/// Throws std::invalid_argument for options that do not go together or say nothing.
/// @param surface the file of the surface
void check_region_options(const RegionOptions& options, const std::string& surface);

/// Returns the areas of the boundary for the tool's tip; none without a boundary. Prints what of it
/// the tool does not fit into. Throws std::invalid_argument for a drawing with faults, by place and
/// remedy. @param rows tool and tolerance of the path
[[nodiscard]] std::vector<Contour> boundary_areas_of(const RegionOptions& options,
                                                     const surface::RowOptions& rows,
                                                     InputFiles& inputs);

/// Returns the regions that options ask for. Prints what of a boundary the tool does not fit into.
/// Throws std::invalid_argument for a drawing with faults, by place and remedy, and for a larger
/// tool that is none.
/// @param rows tool, allowance, tolerance and floor of the path
[[nodiscard]] surface::MilledRegions regions_of(const RegionOptions& options,
                                                const surface::Mesh& mesh,
                                                const surface::RowOptions& rows,
                                                InputFiles& inputs);

}  // namespace sim
