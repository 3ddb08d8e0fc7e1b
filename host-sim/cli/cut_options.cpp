#include "host-sim/cli/cut_options.hpp"

#include <CLI/CLI.hpp>

#include "host-sim/cli/cut_recipe.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/import_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/cut/known_kerf.hpp"
#include "planner/gcode/print_grid.hpp"

namespace sim {
namespace {

constexpr const char* kCutFooter =
    "Parts get the drawn size: the beam goes half a kerf beside the line, on the side of the\n"
    "waste. Power and feed that are not given are chosen: the fastest permissible cut.\n"
    "Lines and arcs stay what they are, other curves become smooth arcs within the tolerance.\n"
    "--layer 'holes: feed=3000, lead-in=line:1' is for the layer, or colour, of that name; keys\n"
    "are power, feed, side (waste, on: on the line, mark: the line is engraved, skip, start: its\n"
    "small circles and short lines mark where the nearest contour begins), kind (cut, score,\n"
    "engrave, fill: in lines across the area, skip), passes, passes-by, z-step, air, pattern (of\n"
    "fill: lines, contour: along its outline), interval, angle, overscan (of its lines), lead-in,\n"
    "lead-out (none, line:MM, arc:MM), overcut, tabs, tab-width, pierce, corner-loop,\n"
    "corner-dwell, corner-angle, common-line, narrow, start (any, straight, corner, usual,\n"
    "tab) and rank (0, 1, …: layers of lower rank are cut first).\n"
    "The layer `*` is any that no other text names; colours have LightBurn's names, too (C01).\n"
    "With --kerf-table the program has the drawn outlines and M190, and the controller goes by\n"
    "its own table, its $PC and $860; tabs, corner loops and dwells keep a contour from it.\n"
    "--layers FILE has one such text to a line.\n"
    "--rule 'hole diameter < thickness: feed=60%' is for all contours of which that holds: hole,\n"
    "outer or open, and diameter, perimeter, area (mm2) or thickness against a number or the\n"
    "thickness, with `and` between several; then skip, mark or settings as of a layer, feed and\n"
    "power also in % of the layer's. The diameter of what is no circle is that of the smallest\n"
    "circle around it; mark engraves the line. Later rules go before earlier ones.\n"
    "\n"
    "Examples:\n"
    "  kerfline cut box.svg --kerf 0.15 --power 60% --feed 600 --layer 'blue: kind=engrave,\n"
    "      power=20%, feed=3000' -o box.nc\n"
    "  kerfline cut part.dxf --material 'CSP 1N' --thickness 2 --lead-in arc:3 -o part.nc "
    "--svg part.svg\n"
    "\n"
    "Exit status: 0 fine, 1 the drawing has faults, 2 the call is wrong.";

void add_common_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options) {
  const auto add = [&](const std::string& key, const std::string& type, const std::string& help) {
    command
        .add_option_function<std::string>(
            "--" + key,
            [options, key](const std::string& value) { options->common.emplace_back(key, value); },
            help)
        ->type_name(type);
  };
  add("power", "POWER", "40 or 40W, 60% of full power, or S600; else chosen for the --material");
  add("feed", "MM/MIN", "Else chosen for the --material");
  add("passes", "COUNT", "Times that each contour is cut, or engraved; 1");
  add("passes-by", "WHAT", "contour: all passes, then the next one; or layer; contour");
  add("z-step", "MM", "Z goes down by this with each pass after the first; 0");
  add("air", "WHAT", "on or M8, M7, off; on");
  add("lead-in", "KIND:MM", "none, line:MM or arc:MM; arc:2");
  add("lead-out", "KIND:MM", "The same; none");
  add("overcut", "MM", "How far to go on where the contour began; 0");
  add("tabs", "COUNT", "Places at which parts stay in the sheet; 0");
  add("tab-width", "MM", "What is left standing at each; 0.5");
  add("pierce", "S", "Time to get through before a cut; 0");
  add("corner-loop", "MM", "Radius of loops in the waste past outer corners; 0, none");
  add("corner-dwell", "S", "Dark rest at corners without a loop; 0, none");
  add("corner-angle", "DEG", "Corners that turn by less are none; 45");
  add("common-line",
      "MM",
      "Cut the line between two parts once where their gap exceeds the kerf by no more; 0, never");
  add("narrow",
      "MM",
      "Cut once along the middle of what is narrower than the kerf, where that takes no more than\n"
      "this off either edge; 0, never");
  add("start",
      "WHERE",
      "Where cuts may begin: any, straight, corner, usual, or tab, where they also end; any");
}

void add_material_options(CLI::App& command, CutCommandOptions& options) {
  options.record.add_to(command);
  command
      .add_option("--kerf",
                  options.kerf_mm,
                  "Width of the cut, as you know it, mm; with --power and --feed no --material is "
                  "needed")
      ->check(in_range(0.0, cut::kMaxKnownKerfMm, "mm"))
      ->type_name("MM");
  command
      .add_option("--entry",
                  options.entry,
                  "Which of the settings that a library has for the --material, as `kerf show` "
                  "names them")
      ->type_name("NAME");
  command.add_option("--thickness", options.thickness_mm, "Of the --material, mm")
      ->check(thickness_range())
      ->type_name("T");
  command
      .add_option("--laser",
                  options.laser,
                  "Name of this machine's laser: cuts by another one say nothing of its kerf")
      ->type_name("NAME");
}

}  // namespace

void add_cut_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options) {
  command.footer(kCutFooter);
  mark_file(command
                .add_option("DRAWING",
                            options->file,
                            "SVG, DXF, PDF, LightBurn, JSON or sheet; - is standard input")
                ->required(),
            FileRole::kInput);
  add_material_options(command, *options);
  add_cut_recipe_options(command, *options);
  add_cut_place_options(command, options->place);
  add_common_options(command, options);
  add_cut_order_options(command, options->order);
  command.add_option("--layer", options->layers, "What is other for a layer; may be repeated")
      ->type_name("TEXT")
      ->allow_extra_args(false);
  const auto add_file = [&](FileRole role, const char* name, std::string& file, const char* help) {
    mark_file(command.add_option(name, file, help)->type_name("FILE"), role);
  };
  add_file(FileRole::kInput, "--layers", options->layers_file, "File of them");
  command
      .add_option("--full-power",
                  options->full_power_w,
                  "What the laser gives at $30; else the machine's or the record's")
      ->check(in_range(0.001, from_thousandths(cnc::kerf::kMaxPowerMw), "W"))
      ->type_name("W");
  command
      .add_option("--kerf-table",
                  options->kerf_table,
                  "Leave the way beside parts to the controller (G42), which has the material as "
                  "table P of $K")
      ->check(in_whole_range(0, 99))
      ->type_name("P");
  command.add_flag("--constant-power", options->constant_power, "M3 instead of M4");
  add_import_options(command, options->import);
  add_text_option(command, options->import.text);
  add_outline_options(command, options->curves);
  add_cut_safety_options(command, options);
  command.add_flag("--anyway", options->anyway, "Cut what is sound of a drawing with faults");
  command.add_flag("--check", options->check, "Drive it and measure how well the parts fit");
  options->post.add_to(command);
  command.add_option("--decimals", options->decimals, "Of places, mm")
      ->check(in_whole_range(cnc::gcode::PrintGrid::kFewest, cnc::gcode::PrintGrid::kMax))
      ->capture_default_str();
  add_file(FileRole::kInput, "--settings", options->settings_file, "The machine's $N=value lines");
  command.add_option("--set", options->set, "One setting of the machine; may be repeated")
      ->type_name("$N=V")
      ->allow_extra_args(false);
  add_cut_sheet_options(command, options->sheet);
  add_cut_rule_options(command, options->shop);
  add_cut_frame_options(command, options->frame);
  add_file(FileRole::kOutput, "-o,--output", options->output, "The program; else standard output");
  add_file(FileRole::kOutput, "--report", options->report, "Write the report as JSON");
  add_cut_output_options(command, options->outputs);
}

}  // namespace sim
