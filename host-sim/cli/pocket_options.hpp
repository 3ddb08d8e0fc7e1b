#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cli/input_files.hpp"
#include "host-sim/cli/post_option.hpp"
#include "host-sim/contour/contour_file.hpp"
#include "host-sim/pocket/mill_program.hpp"
#include "host-sim/pocket/strategy.hpp"
#include "host-sim/pocket/v_carving.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): theirs.
class App;
}

namespace sim {

inline constexpr double kGreatestDepthMm = 1'000.0;
inline constexpr double kLeastToolMm = 0.01;
inline constexpr double kGreatestToolMm = 500.0;

/// The depth of the floor within the contours of a layer.
struct LayerDepth {
  std::string layer;      ///< Name of a layer, or a colour as the drawing has it.
  double depth_mm = 0.0;  ///< Below Z 0, at least 0.

  [[nodiscard]] bool is_of(const drawing::Layer& other) const {
    return layer == other.name || layer == other.colour;
  }
};

/// The options of `kerfline pocket`.
struct PocketCommandOptions {
  std::string file;
  std::string output;
  std::string report;
  std::string svg;
  std::string holes;  ///< Where the program of a drill is written; empty: it is not.
  OutlineOptions outline;
  std::string tool;        ///< A diameter in mm, or the name of one of `tools`.
  std::string tools_file;  ///< Empty: none.
  double tool_mm = 0.0;    ///< By apply_tool().
  double depth_mm = 0.0;
  std::vector<std::string> depths_of{};  ///< `LAYER=MM`.
  double depth_step_mm = 0.0;            ///< 0: half the tool's diameter.
  double stepover_mm = 0.0;              ///< 0: as far as nothing is left.
  double corner_mm = -1.0;               ///< Negative: a tenth of the tool's radius.
  double slope_deg = 3.0;
  cnc::pocket::EntryKind entry = cnc::pocket::EntryKind::kHelix;
  bool conventional = false;
  pocket::Strategy strategy = pocket::Strategy::kContour;
  double engagement_deg = 60.0;
  bool keeps_feed = false;      ///< Where chips are thin, too.
  double finish_mm = 0.0;       ///< 0: no passes of their own along the walls.
  double floor_mm = 0.0;        ///< 0: no level of its own at the floor.
  std::uint32_t wear_tool = 0;  ///< 0: passes along the walls are not compensated.
  std::vector<double> stock{};  ///< Least X and Y, greatest X and Y, mm; empty: not given.
  double rest_of_mm = 0.0;      ///< Diameter of the tool that went before; 0: there was none.
  double v_angle_deg = 0.0;     ///< 0: no V carving.
  bool anyway = false;
  pocket::MillSettings mill;
  unsigned decimals = 4;
  PostOption post;

  [[nodiscard]] double radius_mm() const { return 0.5 * tool_mm; }
  /// Greatest depth of one level.
  [[nodiscard]] double level_mm() const {
    return depth_step_mm > 0.0 ? depth_step_mm : radius_mm();
  }
  [[nodiscard]] bool plunges() const {
    return entry == cnc::pocket::EntryKind::kPlunge || strategy == pocket::Strategy::kPaper;
  }
  [[nodiscard]] std::optional<pocket::StockBox> stock_box() const {
    if (stock.empty()) return std::nullopt;
    return pocket::StockBox{stock[0], stock[1], stock[2], stock[3]};
  }
  [[nodiscard]] bool is_v_carving() const { return v_angle_deg > 0.0; }
};

/// Adds all of them, with their ranges, units and defaults.
void add_pocket_options(CLI::App& command, PocketCommandOptions& options);

/// Reads the tool, and takes from it the values that the call does not give. Throws
/// std::invalid_argument for a tool that is none, and for values that neither gives.
void apply_tool(const CLI::App& command, PocketCommandOptions& options, InputFiles& inputs);

/// Throws std::invalid_argument for options that the strategy does not have.
void check_pocket_options(const CLI::App& command, const PocketCommandOptions& options);

/// Returns the depths that the options give to layers. Throws std::invalid_argument for a text that
/// is none, a depth out of range, and a layer that no part of the drawing has.
[[nodiscard]] std::vector<LayerDepth> layer_depths_of(const PocketCommandOptions& options,
                                                      const std::vector<ContourPart>& parts);

/// How they ask for pockets to be milled.
[[nodiscard]] pocket::StrategyOptions strategy_options_of(const PocketCommandOptions& options);

/// How they ask for areas to be carved: as deep as they and the tool allow.
[[nodiscard]] pocket::VCarveOptions carve_options_of(const PocketCommandOptions& options);

/// How they ask for the machine to be driven.
[[nodiscard]] pocket::MillSettings mill_settings_of(const PocketCommandOptions& options);

}  // namespace sim
