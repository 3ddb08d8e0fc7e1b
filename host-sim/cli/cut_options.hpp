#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/cli/cut_frame_options.hpp"
#include "host-sim/cli/cut_order_options.hpp"
#include "host-sim/cli/cut_output_options.hpp"
#include "host-sim/cli/cut_place_options.hpp"
#include "host-sim/cli/cut_rule_options.hpp"
#include "host-sim/cli/cut_safety_options.hpp"
#include "host-sim/cli/cut_sheet_options.hpp"
#include "host-sim/cli/kerf_options.hpp"
#include "host-sim/cli/outline_options.hpp"
#include "host-sim/cli/post_option.hpp"
#include "host-sim/import/drawing.hpp"

namespace CLI {
class App;
}

namespace sim {

/// The recipe that a call reads, and the recipe that it writes.
struct CutRecipeOptions {
  std::string file;  ///< Recipe to read; empty for none.
  std::string save;  ///< Recipe to write; empty for none.
  /// Rules of the recipe that was read. They apply before the rules of the call.
  std::vector<cut::LayerRule> layers;
};

/// Options of `kerfline cut`.
struct CutCommandOptions {
  std::string file;
  drawing::ImportOptions import;
  /// This tolerance and the 2 um of crossing contours (kFillToleranceMm) keep a cut within 5 um of
  /// the drawing.
  OutlineOptions curves{.tolerance_mm = 0.003};
  RecordOptions record;
  double thickness_mm = 0.0;        ///< Thickness of the material; 0 if not given.
  std::optional<double> kerf_mm{};  ///< Known kerf, mm, which replaces the kerf of the record.
  /// Name of the entry of the material; if empty, any entry is used.
  std::string entry;
  /// Keys and values of the material's entry.
  std::vector<std::pair<std::string, std::string>> known;
  std::string laser;  ///< Name of the machine's laser; may be empty.
  /// Keys and values of LayerSettings for all cuts.
  std::vector<std::pair<std::string, std::string>> common;
  std::vector<std::string> layers;
  std::string layers_file;
  CutRecipeOptions recipe;
  CutPlaceOptions place;
  std::vector<SettingChange> machine_settings;  ///< Settings of the machine that `place` names.
  CutOrderOptions order;
  double full_power_w = 0.0;  ///< Full power of the laser; if 0, see beam_of().
  bool constant_power = false;
  /// Number of the kerf table, if the controller offsets the path by the kerf; otherwise empty.
  std::optional<unsigned> kerf_table{};
  cut::SafetyWishes safety{};
  bool anyway = false;
  bool check = false;
  unsigned decimals = 4;
  PostOption post;
  std::string settings_file;
  std::vector<std::string> set;
  CutSheetOptions sheet;
  CutRuleOptions shop;
  CutFrameOptions frame;
  CutOutputOptions outputs;
};

/// Adds all options, and the text that `--help` prints below them.
void add_cut_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options);

}  // namespace sim
