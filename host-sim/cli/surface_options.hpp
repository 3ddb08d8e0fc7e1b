#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/cli/post_option.hpp"
#include "host-sim/cli/surface_patches.hpp"
#include "host-sim/cli/surface_pictures.hpp"
#include "host-sim/cli/surface_regions.hpp"
#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/stock/cutter.hpp"
#include "host-sim/surface/path/pencil_path.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
}

namespace sim {

/// Lines along which a tool moves over a surface.
enum class SurfacePaths : std::uint8_t {
  kRows,       ///< Lines that are straight in plan.
  kWaterline,  ///< Lines of constant height.
  kContour,    ///< Lines at constant distance from the border, measured over the surface.
  kRough,      ///< Levels whose areas are cleared like pockets.
};

/// The stock around a surface.
struct SurfaceStock {
  std::optional<double> top_mm;  ///< Top; empty for the surface's highest point.
  /// Distance from the surface's box to the stock's edge, mm; empty if not known.
  std::optional<double> margin_mm;
};

/// The layers in which stock is removed.
struct SurfaceLevels {
  double depth_mm = 0.0;  ///< Depth of a layer; 0 for no layers.
  double ramp_deg = 0.0;  ///< Angle of the ramp into the stock; 0 for straight down.
};

/// A path along valleys, in place of rows.
struct PencilOptions {
  bool is_wanted = false;
  double angle_deg = 20.0;  ///< Least angle by which the surface bends in a valley.
};

/// A query for the heights of the tool's tip at given points.
struct HeightQuery {
  std::string points;   ///< File of the points; empty for no query.
  std::string heights;  ///< File for the heights; empty for the standard output.
};

/// Options of `kerfline surface`.
struct SurfaceCommandOptions {
  std::string file;
  surface::ReadOptions reading;
  /// Direction in which the tool approaches, X, Y and Z; empty for down.
  std::vector<double> approach{};
  /// Displacement of the surface in X, Y and Z, mm; empty for none.
  std::vector<double> move_mm{};
  std::string tool;
  double tolerance_mm = 0.01;
  /// Step-over, mm; 0 for a step-over by the scallop, or a tenth of the tool's diameter.
  double step_mm = 0.0;
  double scallop_mm = 0.0;          ///< Greatest height of scallops; 0 for no limit.
  std::optional<double> angle_deg;  ///< Angle of the rows; empty for along X.
  double allowance_mm = 0.0;
  double margin_mm = 0.0;
  std::optional<double> floor_mm;
  SurfaceStock stock;
  SurfaceLevels levels;
  std::optional<double> safe_mm;  ///< Height of rapids; empty for 5 mm above path and surface.
  SurfacePaths paths = SurfacePaths::kRows;
  /// Order of the rows. If empty: zigzag, or one way if a direction is given.
  std::optional<surface::RowOrder> order;
  std::optional<cnc::pocket::Milling> direction;
  RegionOptions regions;
  PencilOptions pencil;
  bool lines_only = false;
  pocket::MillSettings mill;
  unsigned decimals = 4;
  PostOption post;
  PatchOptions patches;
  SurfacePictures pictures;
  std::string output;
  std::string report;
  std::string
      mesh;  ///< File for the triangles of the surface, after all changes to it; empty for none.
  HeightQuery query;

  [[nodiscard]] bool wants_heights() const { return !query.points.empty(); }
  [[nodiscard]] bool wants_patches() const {
    return patches.smooth || patches.like_paper || !patches.file.empty() ||
           !pictures.patches.empty();
  }
  [[nodiscard]] bool wants_program() const { return !wants_heights() && !patches.like_paper; }
};

/// Adds all options, with their ranges, units and defaults.
void add_surface_options(CLI::App& command, SurfaceCommandOptions& options);

/// Checks the options. Throws std::invalid_argument for options that exclude each other, and if an
/// option is missing.
void check_surface_options(const SurfaceCommandOptions& options);

/// Adds the options of roughing in levels.
void add_rough_options(CLI::App& command, SurfaceCommandOptions& options);

/// Checks the options of roughing in levels. Throws std::invalid_argument for options that roughing
/// does not use, and if an option is missing.
void check_rough_options(const SurfaceCommandOptions& options);

/// Returns the step-over of roughing in levels, mm: that of the options, or a step-over that suits
/// the tool. Throws std::invalid_argument if the step-over would leave stock between passes.
[[nodiscard]] double rough_step_of(const SurfaceCommandOptions& options,
                                   const stock::Cutter& cutter);

/// Returns the options of the algorithm that computes rows and lines.
[[nodiscard]] surface::RowOptions row_options_of(const SurfaceCommandOptions& options,
                                                 const stock::Cutter& cutter);

/// Adds the options of paths along valleys.
void add_pencil_options(CLI::App& command, SurfaceCommandOptions& options);

/// Checks the options of a path along valleys. Throws std::invalid_argument for options of rows,
/// because such a path has no rows.
void check_pencil_options(const SurfaceCommandOptions& options);

/// Returns the options of the algorithm that computes paths along valleys.
[[nodiscard]] surface::PencilOptions pencil_options_of(const SurfaceCommandOptions& options,
                                                       const stock::Cutter& cutter);

}  // namespace sim
