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

namespace CLI {  // NOLINT(readability-identifier-naming): theirs.
class App;
}

namespace sim {

/// The lines along which a tool goes over a surface.
enum class SurfacePaths : std::uint8_t {
  kRows,       ///< Straight in plan.
  kWaterline,  ///< At one height each.
  kContour,    ///< At one distance each from the border, over the surface.
  kRough,      ///< Areas of levels, cleared as pockets are.
};

/// The options of `kerfline surface`.
struct SurfaceCommandOptions {
  std::string file;
  surface::ReadOptions reading;
  std::vector<double> approach{};  ///< The tool's direction, X, Y and Z; empty: down.
  std::vector<double> move_mm{};   ///< X, Y and Z; empty: not moved.
  std::string tool;
  double tolerance_mm = 0.01;
  double step_mm = 0.0;             ///< 0: as the scallop asks, or a tenth of the tool's diameter.
  double scallop_mm = 0.0;          ///< 0: any.
  std::optional<double> angle_deg;  ///< None: along X.
  double allowance_mm = 0.0;
  double margin_mm = 0.0;
  std::optional<double> floor_mm;
  std::optional<double> stock_top_mm;  ///< None: the surface's highest point.
  double layer_mm = 0.0;               ///< 0: no layers.
  double ramp_deg = 0.0;               ///< 0: straight down.
  std::optional<double> safe_mm;       ///< None: 5 mm above path and surface.
  SurfacePaths paths = SurfacePaths::kRows;
  std::optional<double> stock_margin_mm;   ///< None: nothing is known of the stock's end.
  std::optional<surface::RowOrder> order;  ///< None: zigzag, or one way with a direction.
  std::optional<cnc::pocket::Milling> direction;
  RegionOptions regions;
  bool pencil = false;  ///< Valleys in place of rows.
  double pencil_angle_deg = 20.0;
  bool lines_only = false;
  pocket::MillSettings mill;
  unsigned decimals = 4;
  PostOption post;
  PatchOptions patches;
  SurfacePictures pictures;
  std::string output;
  std::string report;
  std::string mesh;     ///< Where the surface is written as it counts; empty: it is not.
  std::string at;       ///< Places whose heights are wanted.
  std::string heights;  ///< Where they are written.

  [[nodiscard]] bool wants_heights() const { return !at.empty(); }
  [[nodiscard]] bool wants_patches() const {
    return patches.smooth || patches.like_paper || !patches.file.empty() ||
           !pictures.patches.empty();
  }
  [[nodiscard]] bool wants_program() const { return !wants_heights() && !patches.like_paper; }
};

/// Adds all of them, with their ranges, units and defaults.
void add_surface_options(CLI::App& command, SurfaceCommandOptions& options);

/// Throws std::invalid_argument for options that do not go together, and for those that are
/// missing.
void check_surface_options(const SurfaceCommandOptions& options);

/// Adds those of roughing in levels.
void add_rough_options(CLI::App& command, SurfaceCommandOptions& options);

/// Throws std::invalid_argument for options that do not go with roughing in levels, and for those
/// that are missing.
void check_rough_options(const SurfaceCommandOptions& options);

/// Returns the step of roughing in levels, mm: as it is asked for, or what suits the tool.
/// Throws std::invalid_argument for one that would leave stock between passes.
[[nodiscard]] double rough_step_of(const SurfaceCommandOptions& options,
                                   const stock::Cutter& cutter);

/// Returns how they ask for paths.
[[nodiscard]] surface::RowOptions row_options_of(const SurfaceCommandOptions& options,
                                                 const stock::Cutter& cutter);

/// Adds those of paths along valleys.
void add_pencil_options(CLI::App& command, SurfaceCommandOptions& options);

/// Throws std::invalid_argument for options of rows, of which a path along valleys has none.
void check_pencil_options(const SurfaceCommandOptions& options);

/// How they ask for valleys.
[[nodiscard]] surface::PencilOptions pencil_options_of(const SurfaceCommandOptions& options,
                                                       const stock::Cutter& cutter);

}  // namespace sim
