#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/cli/input_files.hpp"
#include "host-sim/cut/plan.hpp"
#include "host-sim/import/drawing.hpp"
#include "host-sim/sheet/sheet_file.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline cut` for sheets of parts.
struct CutSheetOptions {
  std::string save;         ///< File to write; empty for none.
  double margin_mm = 10.0;  ///< Margin of a sheet that is made from a drawing.
};

/// Adds `--save-sheet` and `--sheet-margin`.
void add_cut_sheet_options(CLI::App& command, CutSheetOptions& options);

/// Input of a job: a drawing, or a sheet together with the drawing of its placed parts.
struct CutInput {
  drawing::Drawing drawn;
  std::optional<sheet::Sheet> sheet{};

  /// Returns whether the sheet has faults or any of its drawings could not be read.
  [[nodiscard]] bool is_broken_sheet() const;
};

/// Reads a drawing or a sheet with the drawings of its parts; the content decides which of them it
/// is. Throws as read_text() does for `file` itself.
[[nodiscard]] CutInput read_cut_input(const std::string& file,
                                      const drawing::ImportOptions& options,
                                      InputFiles& files);

/// Returns the faults in the positions of a sheet's parts; empty if the input is no sheet.
[[nodiscard]] std::vector<drawing::Fault> place_faults(const CutInput& input,
                                                       const std::vector<cut::LayerPlan>& layers,
                                                       const cut::Recipes& recipes);

/// Writes the sheet if the options require it. Throws std::invalid_argument for a drawing without a
/// name, as from standard input.
void save_sheet(const CutSheetOptions& options, const CutInput& input);

}  // namespace sim
