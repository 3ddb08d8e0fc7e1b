#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cli/post_option.hpp"
#include "host-sim/cli/surface_patches.hpp"
#include "host-sim/cli/surface_pictures.hpp"
#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/stock/cutter.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): theirs.
class App;
}

namespace sim {

/// The options of `kerfline surface`.
struct SurfaceCommandOptions {
  std::string file;
  surface::ReadOptions reading;
  std::vector<double> move_mm{};  ///< X, Y and Z; empty: not moved.
  std::string tool;
  double tolerance_mm = 0.01;
  double step_mm = 0.0;     ///< 0: as the scallop asks, or a tenth of the tool's diameter.
  double scallop_mm = 0.0;  ///< 0: any.
  double angle_deg = 0.0;
  double allowance_mm = 0.0;
  double margin_mm = 0.0;
  std::optional<double> floor_mm;
  std::optional<double> stock_top_mm;  ///< None: the surface's highest point.
  double layer_mm = 0.0;               ///< 0: no layers.
  std::optional<double> safe_mm;       ///< None: 5 mm above path and surface.
  surface::RowOrder order = surface::RowOrder::kZigzag;
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
    return patches.like_paper || !patches.file.empty() || !pictures.patches.empty();
  }
  [[nodiscard]] bool wants_program() const { return !wants_heights() && !patches.like_paper; }
};

/// Adds all of them, with their ranges, units and defaults.
void add_surface_options(CLI::App& command, SurfaceCommandOptions& options);

/// Throws std::invalid_argument for options that do not go together, and for those that are
/// missing.
void check_surface_options(const SurfaceCommandOptions& options);

/// How they ask for rows.
[[nodiscard]] surface::RowOptions row_options_of(const SurfaceCommandOptions& options,
                                                 const stock::Cutter& cutter);

}  // namespace sim
