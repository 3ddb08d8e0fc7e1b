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
    "Parts get the drawn size: the beam runs at half a kerf from the line, on the side of the\n"
    "waste. If power and feed are not given, the fastest permissible cut is chosen.\n"
    "Lines and arcs are kept. Other curves become smooth arcs within the tolerance.\n"
    "\n"
    "--layer 'holes: feed=3000, lead-in=line:1' sets values for the layer or colour of that name.\n"
    "Keys: power, feed, side (waste; on: on the line; mark: the line is engraved; skip; start:\n"
    "small circles and short lines of the layer mark where the nearest contour begins), kind\n"
    "(cut, score, engrave, fill: in lines across the area, skip), passes, passes-by, z-step, air,\n"
    "pattern (of a fill: lines, or contour: along its outline), interval, angle and overscan of\n"
    "these lines, lead-in, lead-out (none, line:MM, arc:MM), overcut, tabs, tab-width, pierce,\n"
    "corner-loop, corner-dwell, corner-angle, common-line, narrow, start (any, straight, corner,\n"
    "usual, tab) and rank (0, 1, …: layers of lower rank are cut first).\n"
    "The layer `*` stands for every layer that no other --layer names. LightBurn's names of\n"
    "colours (C01) are known, too. --layers FILE holds such texts, one to a line.\n"
    "\n"
    "With --kerf-table the program contains the drawn outlines and M190, and the controller\n"
    "offsets the path by its own table, its $PC and $860. A contour with tabs, corner loops or\n"
    "corner dwells does not use the table.\n"
    "\n"
    "--rule 'hole diameter < thickness: feed=60%' sets values for all contours that satisfy the\n"
    "condition. A condition is hole, outer or open, or it compares diameter, perimeter, area "
    "(mm2)\n"
    "or thickness with a number or the thickness; `and` joins several. After the colon stand "
    "skip,\n"
    "mark (engrave the line) or the keys of a layer; feed and power may be in % of the layer's.\n"
    "The diameter of a contour other than a circle is that of the smallest circle around it.\n"
    "A later rule overrides an earlier one.\n"
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
  add("power",
      "POWER",
      "Power of the beam, as 40 or 40W, 60% of full power, or S600; default: chosen for the "
      "--material");
  add("feed", "MM/MIN", "Feed of cuts, mm/min; default: chosen for the --material");
  add("passes", "COUNT", "Number of passes over each contour; default: 1");
  add("passes-by",
      "WHAT",
      "Order of passes: contour (all passes of a contour, then the next contour) or layer (a pass "
      "over all contours of a layer, then the next pass); default: contour");
  add("z-step",
      "MM",
      "Distance by which Z goes down for each pass after the first, mm; default: 0");
  add("air", "WHAT", "Air assist: on or M8, M7, off; default: on");
  add("lead-in",
      "KIND:MM",
      "Path from the waste to the contour: none, line:MM or arc:MM; default: arc:2");
  add("lead-out",
      "KIND:MM",
      "Path from the contour back to the waste: none, line:MM or arc:MM; default: none");
  add("overcut", "MM", "Length that is cut again past the start of the contour, mm; default: 0");
  add("tabs", "COUNT", "Number of tabs that hold each part in the sheet; default: 0");
  add("tab-width", "MM", "Width of each tab, mm; default: 0.5");
  add("pierce", "S", "Time of piercing before each cut, s; default: 0");
  add("corner-loop",
      "MM",
      "Radius of loops in the waste past outer corners, mm; default: 0, no loops");
  add("corner-dwell",
      "S",
      "Rest with the beam off at corners without a loop, s; default: 0, no rest");
  add("corner-angle",
      "DEG",
      "Angle from which a change of direction counts as a corner, degrees; default: 45");
  add("common-line",
      "MM",
      "Greatest width by which the gap between two parts may exceed the kerf so that one cut "
      "separates both, mm; default: 0, never");
  add("narrow",
      "MM",
      "Greatest width that one cut along the middle of narrow waste takes off each edge, mm; "
      "narrow\nwaste is narrower than the kerf; default: 0, no such cut");
  add("start",
      "WHERE",
      "Position at which a cut may begin: any, straight, corner, usual, or tab, where it also "
      "ends; "
      "default: any");
}

void add_material_options(CLI::App& command, CutCommandOptions& options) {
  options.record.add_to(command);
  command
      .add_option("--kerf",
                  options.kerf_mm,
                  "Width of the cut, if it is known, mm; with --power and --feed given no "
                  "--material is required")
      ->check(in_range(0.0, cut::kMaxKnownKerfMm, "mm"))
      ->type_name("MM");
  command
      .add_option("--entry",
                  options.entry,
                  "Name of the library's settings for the --material, as listed by `kerf show`")
      ->type_name("NAME");
  command.add_option("--thickness", options.thickness_mm, "Thickness of the --material, mm")
      ->check(thickness_range())
      ->type_name("T");
  command
      .add_option(
          "--laser",
          options.laser,
          "Name of this machine's laser; test cuts by other lasers are not used for its kerf")
      ->type_name("NAME");
}

void add_file(
    CLI::App& command, FileRole role, const char* name, std::string& file, const char* help) {
  mark_file(command.add_option(name, file, help)->type_name("FILE"), role);
}

void add_layer_options(CLI::App& command, CutCommandOptions& options) {
  command
      .add_option("--layer",
                  options.layers,
                  "Values for one layer in place of the general ones, as below; may be repeated")
      ->type_name("TEXT")
      ->allow_extra_args(false);
  add_file(command,
           FileRole::kInput,
           "--layers",
           options.layers_file,
           "File of --layer texts, one to a line");
}

void add_settings_options(CLI::App& command, CutCommandOptions& options) {
  command.add_option("--decimals", options.decimals, "Decimals of positions in mm")
      ->check(in_whole_range(cnc::gcode::PrintGrid::kFewest, cnc::gcode::PrintGrid::kMax))
      ->capture_default_str();
  add_file(command,
           FileRole::kInput,
           "--settings",
           options.settings_file,
           "File of the machine's settings, `$N=value` on each line");
  command
      .add_option(
          "--set", options.set, "One setting of the machine, such as '$110=12000'; may be repeated")
      ->type_name("$N=V")
      ->allow_extra_args(false);
}

}  // namespace

void add_cut_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options) {
  command.footer(kCutFooter);
  mark_file(
      command
          .add_option("DRAWING",
                      options->file,
                      "Drawing as SVG, DXF, PDF, LightBurn, JSON or sheet; - is standard input")
          ->required(),
      FileRole::kInput);
  add_material_options(command, *options);
  add_cut_recipe_options(command, *options);
  add_cut_place_options(command, options->place);
  add_common_options(command, options);
  add_cut_order_options(command, options->order);
  add_layer_options(command, *options);
  command
      .add_option("--full-power",
                  options->full_power_w,
                  "Power of the laser at the greatest S ($30), W; default: as in the machine's "
                  "profile or the record")
      ->check(in_range(0.001, from_thousandths(cnc::kerf::kMaxPowerMw), "W"))
      ->type_name("W");
  command
      .add_option("--kerf-table",
                  options->kerf_table,
                  "Number of the controller's kerf table for the material, as listed by $K; the "
                  "controller then offsets the path (G42)")
      ->check(in_whole_range(0, 99))
      ->type_name("P");
  command.add_flag("--constant-power",
                   options->constant_power,
                   "Use M3 instead of M4: power does not follow the speed");
  add_import_options(command, options->import);
  add_text_option(command, options->import.text);
  add_outline_options(command, options->curves);
  add_cut_safety_options(command, options);
  command.add_flag("--anyway",
                   options->anyway,
                   "Cut the contours without faults although the drawing has faults");
  command.add_flag("--check",
                   options->check,
                   "Run the program in the simulator and measure the error of the cut parts");
  options->post.add_to(command);
  add_settings_options(command, *options);
  add_cut_sheet_options(command, options->sheet);
  add_cut_rule_options(command, options->shop);
  add_cut_frame_options(command, options->frame);
  add_file(command,
           FileRole::kOutput,
           "-o,--output",
           options->outputs.program,
           "File of the program; default: standard output");
  add_file(
      command, FileRole::kOutput, "--report", options->outputs.report, "Write the report as JSON");
  add_cut_output_options(command, options->outputs);
}

}  // namespace sim
