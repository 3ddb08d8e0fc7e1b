#include "host-sim/cli/pocket_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/mill_options.hpp"
#include "host-sim/cli/outline_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "planner/gcode/modal_state.hpp"

namespace sim {
namespace {

constexpr double kMinDepthMm = 0.001;
constexpr double kSteepestDeg = 45.0;

void add_shape_options(CLI::App& command, PocketCommandOptions& options) {
  command
      .add_option(
          "--tool",
          options.tool,
          "Diameter of the tool, mm (the greatest one of a V tool), or the tool's name in --tools")
      ->required()
      ->type_name("MM|NAME");
  mark_file(command
                .add_option(
                    "--tools",
                    options.tools_file,
                    "File of tools, one to a line, as `NAME: diameter=MM, key=value`. Keys: angle "
                    "(of a V tool),\nflutes, feed-per-tooth, feed, plunge-feed, spindle, "
                    "depth-step, stepover. An option\nof the call overrides the file")
                ->type_name("FILE"),
            FileRole::kInput);
  command
      .add_option("--depth",
                  options.depth_mm,
                  "Depth of the pocket below Z 0, mm; with --v-angle the greatest depth")
      ->required()
      ->check(in_range(kMinDepthMm, kGreatestDepthMm, "mm"))
      ->type_name("MM");
  command
      .add_option("--depth-of",
                  options.depths_of,
                  "Depth within the contours of a layer or colour, mm, in place of --depth: deeper "
                  "ones are\npockets in pockets, less deep ones bosses, 0 islands; may be repeated")
      ->type_name("LAYER=MM");
  command
      .add_option("--depth-step",
                  options.depth_step_mm,
                  "Greatest depth of one level, mm; all levels are equal; default: half the tool's "
                  "diameter")
      ->check(in_range(kMinDepthMm, kGreatestDepthMm, "mm"))
      ->type_name("MM");
  command
      .add_option(
          "--stepover",
          options.stepover_mm,
          "Greatest distance between passes, mm; default: the greatest that leaves no stock;\n"
          "for lines half the tool, for spirals half the tool less --corner")
      ->check(in_range(kMinDepthMm, kGreatestToolMm, "mm"))
      ->type_name("MM");
  command
      .add_option(
          "--corner",
          options.corner_mm,
          "Radius of the corners of all passes except those at the wall, mm, up to a sixth\n"
          "of the tool's diameter; default: a twentieth of it")
      ->check(in_range(0.0, kGreatestToolMm, "mm"))
      ->type_name("MM");
}

void add_entry_options(CLI::App& command, PocketCommandOptions& options) {
  using cnc::pocket::EntryKind;
  const std::map<std::string, EntryKind> entries{
      {"helix", EntryKind::kHelix}, {"ramp", EntryKind::kRamp}, {"plunge", EntryKind::kPlunge}};
  command
      .add_option(
          "--entry",
          options.entry,
          "Path into the stock: a helix where one fits, otherwise a ramp along the first pass or,\n"
          "with crescents, along the middle; only ramps; or straight down, for a tool that cuts\n"
          "at its centre or a hole that is drilled before")
      ->transform(CLI::CheckedTransformer(entries))
      ->option_text("helix|ramp|plunge [helix]");
  command.add_option("--slope", options.slope_deg, "Slope of helices and ramps, degrees")
      ->check(in_range(0.1, kSteepestDeg, "degrees"))
      ->type_name("DEG")
      ->capture_default_str();
  command.add_flag(
      "--conventional", options.conventional, "Mill conventionally; default: climb milling");
}

/// Adds the options for allowances, for stock that another tool has left, and for the box of the
/// stock.
void add_stock_shape_options(CLI::App& command, PocketCommandOptions& options) {
  command
      .add_option(
          "--finish",
          options.finish_mm,
          "Allowance that is left at the walls and removed at the end by passes along them, mm, "
          "with\narcs in and out; up to half the tool's diameter")
      ->check(in_range(kMinDepthMm, kGreatestToolMm, "mm"))
      ->type_name("MM");
  command
      .add_option("--finish-floor",
                  options.floor_mm,
                  "Allowance that is left at the floors and removed in one more level, mm; up to\n"
                  "--depth-step")
      ->check(in_range(kMinDepthMm, kGreatestToolMm, "mm"))
      ->type_name("MM");
  command
      .add_option(
          "--wear",
          options.wear_tool,
          "Number of the tool in the D word with which the passes of --finish run under G41 or "
          "G42.\nSet its radius to the excess of your tool's radius over that of --tool, such as "
          "G10 L1 P1 R0.02")
      ->check(in_whole_range(1, cnc::gcode::kToolCount))
      ->type_name("NUMBER");
  command
      .add_option("--rest-of",
                  options.rest_of_mm,
                  "Diameter of the larger tool that milled the pockets before, mm: only the stock "
                  "that it\nleft is milled")
      ->check(in_range(kMinToolMm, kGreatestToolMm, "mm"))
      ->type_name("MM");
  command
      .add_option(
          "--stock",
          options.stock,
          "Box of the stock in plan, mm. Pockets that reach its edge are open there: the tool "
          "comes in\nfrom outside the stock and goes beyond it as required; not with --strategy "
          "paper")
      ->expected(4)
      ->delimiter(',')
      ->type_name("XMIN,YMIN,XMAX,YMAX");
}

void add_strategy_options(CLI::App& command, PocketCommandOptions& options) {
  using pocket::Strategy;
  const std::map<std::string, Strategy> strategies{{"contour", Strategy::kContour},
                                                   {"spiral", Strategy::kSpiral},
                                                   {"adaptive", Strategy::kAdaptive},
                                                   {"zigzag", Strategy::kZigzag},
                                                   {"paper", Strategy::kPaper}};
  command
      .add_option(
          "--strategy",
          options.strategy,
          "Shape of the passes: along the walls; spirals from the middle outwards where only a\n"
          "ring is between passes; crescents that engage at most --engagement of the tool, for\n"
          "hard stock and deep levels; lines along X; or the paper's spiral as printed, for one\n"
          "convex contour, with plunges")
      ->transform(CLI::CheckedTransformer(strategies))
      ->option_text("contour|spiral|adaptive|zigzag|paper [contour]");
  command
      .add_option("--engagement",
                  options.engagement_deg,
                  "Greatest angle of the tool's circumference that cuts with --strategy adaptive, "
                  "degrees;\nentries and stretches narrower than 1.2 tools exceed it, which "
                  "--report lists")
      ->check(in_range(pocket::kMinEngagementDeg, pocket::kGreatestEngagementDeg, "degrees"))
      ->type_name("DEG")
      ->capture_default_str();
  command.add_flag(
      "--keep-feed",
      options.keeps_feed,
      "Keep --feed where --engagement makes chips thin; default: --feed divided by the\n"
      "sine of --engagement there, below 90 degrees");
  command
      .add_option("--v-angle",
                  options.v_angle_deg,
                  "Included angle of a V tool, degrees: it carves along the middle of each shape,\n"
                  "as deep as its width requires there")
      ->check(in_range(pocket::kMinVAngleDeg, pocket::kGreatestVAngleDeg, "degrees"))
      ->type_name("DEG");
}

void add_height_options(CLI::App& command, pocket::MillSettings& mill) {
  command.add_option("--safe", mill.safe_mm, "Z of rapids between rows, mm")
      ->check(in_range(0.1, kGreatestDepthMm, "mm"))
      ->type_name("MM")
      ->capture_default_str();
}

}  // namespace

void add_pocket_options(CLI::App& command, PocketCommandOptions& options) {
  mark_file(
      command
          .add_option("FILE", options.file, "A drawing, or contours as text; - is standard input")
          ->required(),
      FileRole::kInput);
  add_shape_options(command, options);
  add_entry_options(command, options);
  add_strategy_options(command, options);
  add_stock_shape_options(command, options);
  add_mill_options(command, options.mill, "; default: that of --tools");
  add_height_options(command, options.mill);
  add_outline_options(command, options.outline);
  command.add_flag("--anyway",
                   options.anyway,
                   "Mill the regions that the tool reaches, although others are left");
  options.post.add_to(command);
  command.add_option("--decimals", options.decimals, "Decimals of positions in mm")
      ->check(in_whole_range(cnc::gcode::PrintGrid::kFewest, cnc::gcode::PrintGrid::kMax))
      ->capture_default_str();
  const auto add_output = [&](const char* name, std::string& file, const char* help) {
    mark_file(command.add_option(name, file, help)->type_name("FILE"), FileRole::kOutput);
  };
  add_output("-o,--output", options.output, "File of the program; default: standard output");
  add_output("--report", options.report, "Write passes, rows and lengths as JSON");
  add_output("--svg", options.svg, "Draw the pockets and their passes");
  add_output(
      "--holes",
      options.holes,
      "Write a program for a drill of the tool's diameter or slightly less: it drills a hole, one "
      "peck\nper level, at each point where --entry plunge goes down");
}

pocket::StrategyOptions strategy_options_of(const PocketCommandOptions& options) {
  const double radius = options.radius_mm();
  cnc::pocket::PocketOptions<double> wanted;
  wanted.clearing.tool_radius = radius;
  wanted.clearing.corner_radius = options.corner_mm < 0.0 ? 0.1 * radius : options.corner_mm;
  const bool is_zigzag = options.strategy == pocket::Strategy::kZigzag;
  const double usual_stepover = is_zigzag ? radius : options.tool_mm;
  wanted.clearing.stepover = options.stepover_mm > 0.0 ? options.stepover_mm : usual_stepover;
  wanted.entry.kind = options.entry;
  wanted.entry.slope = std::tan(options.slope_deg * std::numbers::pi / 180.0);
  // A helix of a larger radius leaves a core in its middle.
  wanted.entry.helix_radius = 0.9 * radius;
  wanted.milling =
      options.conventional ? cnc::pocket::Milling::kConventional : cnc::pocket::Milling::kClimb;
  wanted.depth = options.depth_mm;
  wanted.depth_step = options.level_mm();
  return {.strategy = options.strategy,
          .pocket = wanted,
          .engagement_deg = options.engagement_deg,
          .finish_mm = options.finish_mm,
          .has_lead_lines = options.wear_tool != 0,
          .floor_mm = options.floor_mm,
          .former_radius_mm = 0.5 * options.rest_of_mm,
          .stock = options.stock_box()};
}

pocket::VCarveOptions carve_options_of(const PocketCommandOptions& options) {
  const double half_angle = 0.5 * options.v_angle_deg * std::numbers::pi / 180.0;
  const double depth_of_tool_mm = options.radius_mm() / std::tan(half_angle);
  return {.included_angle_deg = options.v_angle_deg,
          .greatest_depth_mm = std::min(options.depth_mm, depth_of_tool_mm)};
}

pocket::MillSettings mill_settings_of(const PocketCommandOptions& options) {
  pocket::MillSettings mill = options.mill;
  mill.wear_tool = options.wear_tool;
  mill.wears_to_left = !options.conventional;
  if (options.strategy == pocket::Strategy::kAdaptive && !options.keeps_feed) {
    mill.light_feed_mm_min = mill.feed_mm_min * pocket::thin_chip_factor(options.engagement_deg);
  }
  return mill;
}

}  // namespace sim
