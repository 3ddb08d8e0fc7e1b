#include "host-sim/cli/cut_sheet_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/picture_files.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/sheet/place_parts.hpp"
#include "host-sim/sheet/save_sheet.hpp"
#include "host-sim/sheet/sheet_check.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

constexpr double kMaxSheetMarginMm = 1000.0;

}  // namespace

void add_cut_sheet_options(CLI::App& command, CutSheetOptions& options) {
  mark_file(command.add_option("--save-sheet", options.save, "Write the job as a sheet file")
                ->type_name("FILE"),
            FileRole::kOutput);
  command
      .add_option("--sheet-margin",
                  options.margin_mm,
                  "Margin around a drawing that is saved as a sheet, mm")
      ->check(in_range(0.0, kMaxSheetMarginMm, "mm"))
      ->type_name("MM")
      ->capture_default_str();
}

bool CutInput::is_broken_sheet() const {
  const auto is_unreadable = [](const drawing::Fault& fault) {
    return fault.kind == drawing::FaultKind::kUnreadable;
  };
  return sheet && (!sheet->faults.empty() || std::ranges::any_of(drawn.faults, is_unreadable));
}

CutInput read_cut_input(const std::string& file,
                        const drawing::ImportOptions& options,
                        InputFiles& files) {
  const std::string text = InputFiles::read(file, true);
  const bool is_sheet = sheet::is_sheet(text);
  files.add(is_sheet ? "sheet" : "drawing", file, text);
  if (!is_sheet) {
    drawing::ImportOptions with_pictures = options;
    with_pictures.read_beside = reader_beside(file);
    return {drawing::read_drawing(file, text, with_pictures)};
  }
  sheet::Sheet sheet = sheet::read_sheet(file, text);
  const auto read = [&files](const std::string& name) {
    std::string drawing = InputFiles::read(name, true);
    files.add("drawing", name, drawing);
    return drawing;
  };
  drawing::Drawing drawn = place_parts(sheet, read, options);
  return {std::move(drawn), std::move(sheet)};
}

std::vector<drawing::Fault> place_faults(const CutInput& input,
                                         const std::vector<cut::LayerPlan>& layers,
                                         const cut::Recipes& recipes) {
  if (!input.sheet) return {};
  std::vector<sheet::ContourUse> uses;
  for (std::size_t i = 0; i < input.drawn.contours.size(); ++i) {
    const drawing::DrawnContour& contour = input.drawn.contours[i];
    const cut::LayerPlan& plan = recipes.of(i, layers[contour.entity.layer]);
    // With common lines, parts may touch edge to edge. The plan then finds parts that are too near.
    const bool shares_lines = plan.settings.common_line_mm > 0.0;
    uses.push_back({.is_cut = cut::is_driven(plan.settings.side),
                    .is_edge = contour.closed && plan.settings.side == cut::Side::kWaste,
                    .kerf_mm = shares_lines ? 0.0 : plan.condition.kerf_mm});
  }
  return sheet::check_places(input.drawn, uses);
}

void save_sheet(const CutSheetOptions& options, const CutInput& input) {
  if (options.save.empty()) return;
  if (input.drawn.file == "-") {
    throw std::invalid_argument(
        "--save-sheet: a sheet names its drawings, and standard input has no name; name the file");
  }
  const sheet::Sheet saved = input.sheet
                                 ? moved_to(*input.sheet, options.save)
                                 : sheet::sheet_of(input.drawn, options.save, options.margin_mm);
  write_file(options.save, text_of(saved));
}

}  // namespace sim
