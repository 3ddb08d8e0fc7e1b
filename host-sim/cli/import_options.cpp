#include "host-sim/cli/import_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

#include "host-sim/cli/value_range.hpp"
#include "host-sim/import/drawing_unit.hpp"

namespace sim {
namespace {

constexpr const char* kAutoGap = "auto";

CLI::Validator gap_values() {
  const CLI::Validator range = in_range(drawing::kMinGapMm, drawing::kGreatestGapMm, "mm");
  const auto check = [range](const std::string& text) -> std::string {
    if (text == kAutoGap) return {};
    const std::string wrong = range(text);
    return wrong.empty() ? wrong : fmt::format("{}; or `{}`", wrong, kAutoGap);
  };
  return CLI::Validator{check, ""};
}

CLI::Validator unit_values() {
  const CLI::Validator range = in_range(drawing::kMinUnitMm, drawing::kGreatestUnitMm, "mm");
  const auto check = [range](const std::string& text) -> std::string {
    if (drawing::drawing_unit_mm(text) || range(text).empty()) return {};
    return fmt::format("`{}` is no unit; choose {}, or a length in millimetres",
                       text,
                       drawing::drawing_unit_names());
  };
  return CLI::Validator{check, ""};
}

}  // namespace

void add_import_options(CLI::App& command, drawing::ImportOptions& options) {
  options.mends_gaps = true;
  command
      .add_option_function<std::string>(
          "--gap",
          [&options](const std::string& text) {
            options.finds_gap = options.mends_gaps = text == kAutoGap;
            if (!options.finds_gap) options.gap_mm = std::stod(text);
          },
          fmt::format("Greatest gap between two ends that are joined, mm, 0 to {}; `auto`: a wider "
                      "gap, up to 0.5 mm, if it closes most open ends. Without this option two "
                      "ends up to 0.2 mm apart without a third end near them are joined, too, and "
                      "contours that nearly close are closed",
                      drawing::kGreatestGapMm))
      ->check(gap_values())
      ->type_name("MM|auto")
      ->default_str(fmt::format("{}", options.gap_mm));
  command
      .add_option_function<std::string>(
          "--drawing-unit",
          [&options](const std::string& text) {
            const auto named = drawing::drawing_unit_mm(text);
            options.unit_mm = named ? *named : std::stod(text);
          },
          fmt::format("Unit of a DXF, or of the pixels of an SVG, in place of the unit in the "
                      "drawing: {}, or the length of the unit in mm",
                      drawing::drawing_unit_names()))
      ->check(unit_values())
      ->type_name("UNIT");
}

}  // namespace sim
