#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/cli/input_files.hpp"
#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/path/row_path.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
}

namespace sim {

/// Limit of the tool at a boundary.
enum class BoundarySide : std::uint8_t {
  kInside,   ///< The tool's rim stays inside.
  kOn,       ///< The tool's tip ends on the line.
  kOutside,  ///< The tool's rim is just beyond the line.
};

/// Options of `kerfline surface` for the region of the rows.
struct RegionOptions {
  std::string boundary;  ///< Drawing of the boundary; empty for none.
  BoundarySide side = BoundarySide::kOn;
  std::string slope;    ///< Range of slopes, `LOW:HIGH` in degrees; empty for any.
  std::string rest_of;  ///< Larger tool that milled before; empty for none.
  double rest_allowance_mm = 0.0;
  /// Thickness, mm, above which stock is rest. If 0: three times the tolerance, but at least 0.02
  /// mm.
  double rest_depth_mm = 0.0;

  [[nodiscard]] bool any() const { return !boundary.empty() || !slope.empty() || !rest_of.empty(); }
};

/// Adds all options, with their ranges, units and defaults.
void add_region_options(CLI::App& command, RegionOptions& options);

/// Checks the options. Throws std::invalid_argument for options that exclude each other or have no
/// effect.
/// @param surface the file of the surface
void check_region_options(const RegionOptions& options, const std::string& surface);

/// Returns the areas of the boundary for the tool's tip; empty without a boundary. Prints the parts
/// of the boundary into which the tool does not fit. Throws std::invalid_argument for a drawing
/// with faults, with position and remedy.
/// @param rows tool and tolerance of the path
[[nodiscard]] std::vector<Contour> boundary_areas_of(const RegionOptions& options,
                                                     const surface::RowOptions& rows,
                                                     InputFiles& inputs);

/// Returns the regions that the options describe. Prints the parts of a boundary into which the
/// tool does not fit. Throws std::invalid_argument for a drawing with faults, with position and
/// remedy, and if `rest_of` names no larger tool.
/// @param rows tool, allowance, tolerance and floor of the path
[[nodiscard]] surface::MilledRegions regions_of(const RegionOptions& options,
                                                const surface::Mesh& mesh,
                                                const surface::RowOptions& rows,
                                                InputFiles& inputs);

}  // namespace sim
