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

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name.
class App;
}

namespace sim {

inline constexpr double kGreatestDepthMm = 1'000.0;
inline constexpr double kMinToolMm = 0.01;
inline constexpr double kGreatestToolMm = 500.0;

/// Depth of the floor within the contours of a layer.
struct LayerDepth {
  std::string layer;      ///< Name of a layer, or a colour in the drawing's spelling.
  double depth_mm = 0.0;  ///< Depth below Z 0, at least 0.

  [[nodiscard]] bool is_of(const drawing::Layer& other) const {
    return layer == other.name || layer == other.colour;
  }
};

/// Options of `kerfline pocket`.
struct PocketCommandOptions {
  std::string file;
  std::string output;
  std::string report;
  std::string svg;
  std::string holes;  ///< File for the program of a drill; empty for none.
  OutlineOptions outline;
  std::string tool;        ///< Diameter in mm, or the name of a tool in `tools_file`.
  std::string tools_file;  ///< File of tools; empty for none.
  double tool_mm = 0.0;    ///< Diameter of the tool, set by apply_tool().
  double depth_mm = 0.0;
  std::vector<std::string> depths_of{};  ///< Texts `LAYER=MM`.
  double depth_step_mm = 0.0;  ///< Greatest depth of a level; 0 for half the tool's diameter.
  double stepover_mm = 0.0;    ///< Step-over; 0 for the greatest at which no stock is left.
  double corner_mm = -1.0;     ///< Radius of corners; negative for a tenth of the tool's radius.
  double slope_deg = 3.0;
  cnc::pocket::EntryKind entry = cnc::pocket::EntryKind::kHelix;
  bool conventional = false;
  pocket::Strategy strategy = pocket::Strategy::kContour;
  double engagement_deg = 60.0;
  bool keeps_feed = false;  ///< Whether the feed stays the same where chips are thin.
  /// Allowance for separate passes along the walls, mm; 0 for no such passes.
  double finish_mm = 0.0;
  double floor_mm = 0.0;  ///< Allowance for a separate level at the floor, mm; 0 for no such level.
  /// Number of the tool whose radius compensates the passes along walls; 0 for no compensation.
  std::uint32_t wear_tool = 0;
  std::vector<double> stock{};  ///< Least X and Y, greatest X and Y, mm; empty if not given.
  double rest_of_mm = 0.0;      ///< Diameter of the former, larger tool; 0 if there was none.
  double v_angle_deg = 0.0;     ///< Angle of the V tool; 0 for no V carving.
  bool anyway = false;
  pocket::MillSettings mill;
  unsigned decimals = 4;
  PostOption post;

  [[nodiscard]] double radius_mm() const { return 0.5 * tool_mm; }
  /// Returns the greatest depth of one level.
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

/// Adds all options, with their ranges, units and defaults.
void add_pocket_options(CLI::App& command, PocketCommandOptions& options);

/// Reads the tool, and completes the options by its values where the call gives none. Throws
/// std::invalid_argument for a text that names no tool, and for values that neither the call nor
/// the tool gives.
void apply_tool(const CLI::App& command, PocketCommandOptions& options, InputFiles& inputs);

/// Checks the options. Throws std::invalid_argument for options that the strategy does not use.
void check_pocket_options(const CLI::App& command, const PocketCommandOptions& options);

/// Returns the depths that the options give to layers. Throws std::invalid_argument for a text of
/// the wrong form, a depth out of range, and a layer that no part of the drawing has.
[[nodiscard]] std::vector<LayerDepth> layer_depths_of(const PocketCommandOptions& options,
                                                      const std::vector<ContourPart>& parts);

/// Returns the options of the strategy with which pockets are milled.
[[nodiscard]] pocket::StrategyOptions strategy_options_of(const PocketCommandOptions& options);

/// Returns the options of V carving, with the greatest depth that both --depth and the tool permit.
[[nodiscard]] pocket::VCarveOptions carve_options_of(const PocketCommandOptions& options);

/// Returns feeds, spindle, coolant and heights of the program.
[[nodiscard]] pocket::MillSettings mill_settings_of(const PocketCommandOptions& options);

}  // namespace sim
