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

/// The call of `kerfline cut`.
struct CutCommandOptions {
  std::string file;
  drawing::ImportOptions import;
  /// With the 2 um of contours that cross (kFillToleranceMm) a cut is within 5 um of the drawing.
  OutlineOptions curves{.tolerance_mm = 0.003};
  RecordOptions record;
  double thickness_mm = 0.0;                                ///< 0: not given.
  std::optional<double> kerf_mm{};                          ///< Known, in place of the record's.
  std::string entry;                                        ///< Of the material; empty: any.
  std::vector<std::pair<std::string, std::string>> known;   ///< As the material's entry has it.
  std::string laser;                                        ///< Of this machine; empty: not named.
  std::vector<std::pair<std::string, std::string>> common;  ///< Keys of LayerSettings.
  std::vector<std::string> layers;
  std::string layers_file;
  std::vector<cut::LayerRule> recipe_layers;  ///< Before those of `layers`.
  std::string recipe;                         ///< File to read; empty: none.
  std::string save_recipe;                    ///< File to write; empty: none.
  CutPlaceOptions place;
  std::vector<SettingChange> machine_settings;  ///< Those of the machine that `place` names.
  CutOrderOptions order;
  double full_power_w = 0.0;  ///< 0: see beam_of().
  bool constant_power = false;
  std::optional<unsigned> kerf_table{};  ///< The controller finds the way beside parts.
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
  std::string output;
  std::string report;
  CutOutputOptions outputs;
};

/// Adds all options and the text below them.
void add_cut_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options);

}  // namespace sim
