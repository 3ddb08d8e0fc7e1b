#include "host-sim/cli/surface_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "host-sim/cli/cutter_text.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/mill_options.hpp"
#include "host-sim/cli/value_range.hpp"

namespace sim {
namespace {

constexpr double kMinMm = 1.0e-6;
constexpr double kMinSurfaceToleranceMm = 1.0e-4;
constexpr double kGreatestSurfaceToleranceMm = 5.0;
/// Least scallop as a multiple of the tolerance. At least half of the scallop is then available for
/// the distance of the rows.
constexpr double kMinScallopTolerances = 2.0;

void add_reading_options(CLI::App& command, SurfaceCommandOptions& options) {
  command
      .add_option(
          "--unit", options.reading.unit_mm, "Length of the file's unit, mm: 25.4 is inches")
      ->check(in_range(kMinMm, 1.0e6, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option("--pitch",
                  options.reading.pitch_mm,
                  "Distance between the points of a height map, mm; default: as given in the file")
      ->check(in_range(kMinMm, surface::kFarthestMm, "mm"))
      ->type_name("MM");
  command
      .add_option("--height",
                  options.reading.height_mm,
                  "Height of a picture's white above its black, mm; default: as given in the file")
      ->check(in_range(kMinMm, surface::kFarthestMm, "mm"))
      ->type_name("MM");
  command.add_flag(
      "--repair",
      options.reading.repair,
      "Replace missing points and outliers by values from their neighbours, and print them");
  command
      .add_option(
          "--approach",
          options.approach,
          "Direction in which the tool approaches, in coordinates of FILE: the surface is "
          "rotated about\na level axis until it points down, before --move; default: 0,0,-1")
      ->expected(3)
      ->delimiter(',')
      ->type_name("X,Y,Z");
  command.add_option("--move", options.move_mm, "Vector by which the surface is moved, mm")
      ->expected(3)
      ->delimiter(',')
      ->type_name("X,Y,Z");
}

void add_stock_layer_options(CLI::App& command, SurfaceCommandOptions& options) {
  command
      .add_option("--allowance",
                  options.allowance_mm,
                  "Thickness of stock that is left on the whole surface, mm")
      ->check(in_range(0.0, 100.0, "mm"))
      ->type_name("MM");
  command
      .add_option(
          "--stock-top",
          options.stock.top_mm,
          "Z of the stock's top, mm, to which rapids go down; default: the surface's highest point")
      ->check(in_range(-surface::kFarthestMm, surface::kFarthestMm, "mm"))
      ->type_name("MM");
  command
      .add_option("--layers",
                  options.levels.depth_mm,
                  "Depth of a layer of roughing, mm: layers from the top of the stock downwards, "
                  "each where it is\nabove the surface")
      ->check(in_range(0.001, 1000.0, "mm"))
      ->type_name("MM");
}

void add_direction_option(CLI::App& command, SurfaceCommandOptions& options) {
  const auto take = [&options](const std::string& name) {
    options.direction.reset();
    if (name == "climb") options.direction = cnc::pocket::Milling::kClimb;
    if (name == "conventional") options.direction = cnc::pocket::Milling::kConventional;
  };
  command
      .add_option_function<std::string>(
          "--direction",
          take,
          "Direction of milling for a spindle that rotates clockwise: the stock that is still to "
          "be cut is\non the right for climb, on the left for conventional. Rows then all run in "
          "one direction")
      ->check(CLI::IsMember({"climb", "conventional", "both"}))
      ->option_text("climb|conventional|both [both]");
}

/// Adds the options that choose lines and their direction.
void add_line_options(CLI::App& command, SurfaceCommandOptions& options) {
  const std::map<std::string, SurfacePaths> paths{{"rows", SurfacePaths::kRows},
                                                  {"waterline", SurfacePaths::kWaterline},
                                                  {"contour", SurfacePaths::kContour},
                                                  {"rough", SurfacePaths::kRough}};
  command
      .add_option("--paths",
                  options.paths,
                  "Kind of lines: straight rows, lines of constant height, lines at constant "
                  "distance from the\nborder over the surface, or roughing, in which the areas of "
                  "levels are cleared like pockets")
      ->transform(CLI::CheckedTransformer(paths))
      ->option_text("rows|waterline|contour|rough [rows]");
  command
      .add_option("--angle",
                  options.angle_deg,
                  "Angle of rows from X, counter-clockwise, degrees; default: 0")
      ->check(in_range(-360.0, 360.0, "degrees"))
      ->type_name("DEG");
  const std::map<std::string, surface::RowOrder> orders{{"zigzag", surface::RowOrder::kZigzag},
                                                        {"oneway", surface::RowOrder::kOneWay}};
  command
      .add_option(
          "--order", options.order, "Order of rows: to and fro, or all in one direction with lifts")
      ->transform(CLI::CheckedTransformer(orders))
      ->option_text("zigzag|oneway [zigzag]");
  add_direction_option(command, options);
}

void add_row_options(CLI::App& command, SurfaceCommandOptions& options) {
  command
      .add_option(
          "--tool",
          options.tool,
          "Diameter in mm and kind of the tool, flat by default; for a bull nose its corner "
          "radius; for a V\nits angle in degrees and the diameter of its tip. The kind may come "
          "first: ball:4")
      ->type_name(kCutterForm);
  command
      .add_option("--tolerance",
                  options.tolerance_mm,
                  "Tolerance of the path, mm: the tip is never below the height of touch, and at "
                  "most twice\nthe tolerance above it")
      ->check(in_range(kMinSurfaceToleranceMm, kGreatestSurfaceToleranceMm, "mm"))
      ->capture_default_str();
  command
      .add_option("--step",
                  options.step_mm,
                  "Distance between rows in plan, levels in Z, or lines over the surface, mm; "
                  "default: by\n--scallop, or a tenth of the tool's diameter")
      ->check(in_range(0.001, 500.0, "mm"))
      ->type_name("MM");
  command
      .add_option(
          "--scallop",
          options.scallop_mm,
          "Greatest height of the stock between rows, normal to the surface, mm: rows are added "
          "where the\nsurface is steep across them; waterlines keep this height where the surface "
          "is 45 degrees or steeper")
      ->check(in_range(1.0e-4, 50.0, "mm"))
      ->type_name("MM");
  command
      .add_option("--margin",
                  options.margin_mm,
                  "Distance by which rows extend beyond the surface's box, mm")
      ->check(in_range(0.0, 1000.0, "mm"))
      ->type_name("MM");
  command
      .add_option("--floor",
                  options.floor_mm,
                  "Least Z of the tip, mm; outside the surface the tip runs at this Z, where rows "
                  "otherwise end")
      ->check(in_range(-surface::kFarthestMm, surface::kFarthestMm, "mm"))
      ->type_name("MM");
  command.add_flag(
      "--lines", options.lines_only, "Write no arcs, for controllers without G18 and G19");
}

void add_patch_options(CLI::App& command, PatchOptions& options) {
  mark_file(command
                .add_option("--patches",
                            options.file,
                            "Fit smooth bicubic patches to the positions of the tip over a grid's "
                            "points, and write\nthe patches")
                ->type_name("FILE"),
            FileRole::kOutput);
  command.add_flag("--smooth",
                   options.smooth,
                   "Mill along smooth patches: over a noisy grid the path is smooth, never cuts "
                   "in, and is up to\n--fit-tolerance higher");
  command
      .add_option("--fit-tolerance",
                  options.fit_mm,
                  "Tolerance of patches, mm; default: --tolerance, or 1 for --like-paper")
      ->check(in_range(1.0e-4, 100.0, "mm"))
      ->type_name("MM");
  command.add_flag(
      "--like-paper",
      options.like_paper,
      "Count the flat pieces of the patches by the tests of paper 4, and write no program");
  command
      .add_option(
          "--flatness", options.flatness_mm, "Flatness of the pieces that --like-paper counts, mm")
      ->check(in_range(1.0e-4, 100.0, "mm"))
      ->capture_default_str();
}

void check_approach(const SurfaceCommandOptions& options) {
  if (options.approach.empty()) return;
  double square = 0.0;
  for (const double part : options.approach) square += part * part;
  if (!(square > 0.0 && std::isfinite(square))) {
    throw std::invalid_argument("--approach: must be a direction, such as -1,0,0");
  }
  if (options.wants_patches()) {
    throw std::invalid_argument(
        "--approach: patches fit a grid only as seen from above; leave --approach out");
  }
}

/// Checks the options of a path along patches. Throws std::invalid_argument for options that
/// exclude --smooth.
void check_smooth(const SurfaceCommandOptions& options) {
  if (!options.patches.smooth) return;
  for (const auto& [name, is_given, reason] :
       {std::tuple{"--pencil", options.pencil.is_wanted, "a smooth surface has no valleys"},
        std::tuple{"--at", options.wants_heights(), "it writes the tip's exact heights"},
        std::tuple{"--like-paper", options.patches.like_paper, "it makes no path"}}) {
    if (!is_given) continue;
    throw std::invalid_argument(fmt::format("{}: {}; leave it out, or --smooth", name, reason));
  }
}

/// Checks the options of the kind of lines. Throws std::invalid_argument for options that this kind
/// of lines does not use.
void check_line_options(const SurfaceCommandOptions& options) {
  const bool are_rows = options.paths == SurfacePaths::kRows;
  const auto refuse = [](const char* option, const char* remedy) {
    throw std::invalid_argument(fmt::format("{}: {}", option, remedy));
  };
  if (options.direction && options.order == surface::RowOrder::kZigzag) {
    refuse("--direction", "rows to and fro cut in both directions; use --order oneway");
  }
  if (options.stock.margin_mm && options.paths != SurfacePaths::kRough) {
    refuse("--stock-margin",
           "only --paths rough uses the stock's margin; leave it out, or add --paths rough");
  }
  if (are_rows) return;
  if (options.pencil.is_wanted)
    refuse("--pencil", "mills along valleys, not along --paths; leave one out");
  if (options.angle_deg) refuse("--angle", "only rows have an angle; leave it out, or --paths");
  if (options.order) {
    refuse("--order", "only rows have an order; give the lines of --paths a --direction");
  }
  if (options.paths == SurfacePaths::kRough) return check_rough_options(options);
  if (options.levels.depth_mm > 0.0) {
    refuse("--layers", "only rows have layers; leave it out, because waterlines go down by --step");
  }
}

}  // namespace

void add_surface_options(CLI::App& command, SurfaceCommandOptions& options) {
  mark_file(
      command.add_option(
          "FILE", options.file, "A measured grid, a mesh or a height map; - is standard input"),
      FileRole::kInput);
  add_reading_options(command, options);
  add_row_options(command, options);
  add_line_options(command, options);
  add_stock_layer_options(command, options);
  add_rough_options(command, options);
  add_region_options(command, options.regions);
  add_pencil_options(command, options);
  add_patch_options(command, options.patches);
  add_surface_picture_options(command, options.pictures);
  add_mill_options(command, options.mill);
  command
      .add_option("--slot-feed",
                  options.mill.slot_feed_mm_min,
                  "Feed along rows of layers with stock on both sides, mm/min; default: --feed")
      ->check(in_range(0.1, 1.0e6, "mm/min"))
      ->type_name("MM/MIN");
  command
      .add_option("--ramp",
                  options.levels.ramp_deg,
                  "Angle of the ramp above the first line on which the tool enters the stock, "
                  "degrees; default:\nstraight down")
      ->check(in_range(0.1, 60.0, "degrees"))
      ->type_name("DEG");
  command
      .add_option(
          "--safe", options.safe_mm, "Z of rapids, mm; default: 5 mm above path and surface")
      ->check(in_range(-surface::kFarthestMm, surface::kFarthestMm, "mm"))
      ->type_name("MM");
  command.add_option("--decimals", options.decimals, "Decimals of positions in mm")
      ->check(in_whole_range(cnc::gcode::PrintGrid::kFewest, cnc::gcode::PrintGrid::kMax))
      ->capture_default_str();
  options.post.add_to(command);
  const auto add_output = [&](const char* name, std::string& file, const char* help) {
    mark_file(command.add_option(name, file, help)->type_name("FILE"), FileRole::kOutput);
  };
  add_output("-o,--output", options.output, "File of the program; default: standard output");
  add_output("--report", options.report, "Write elements, rows and lengths as JSON");
  add_output(
      "--mesh", options.mesh, "Write the triangles of the milled surface as PLY with doubles");
  mark_file(command
                .add_option("--at",
                            options.query.points,
                            "File of positions, `X Y` in mm on each line: write the heights of the "
                            "tip there in place of\na program")
                ->type_name("FILE"),
            FileRole::kInput);
  add_output(
      "--heights", options.query.heights, "File of `X Y Z` for --at; default: standard output");
}

void check_surface_options(const SurfaceCommandOptions& options) {
  if (options.file.empty()) {
    throw std::invalid_argument(
        "surface: FILE is missing; give a measured grid, a mesh or a height map");
  }
  check_approach(options);
  if (options.tool.empty())
    throw std::invalid_argument("--tool is missing; give it, such as ball:4");
  if (!options.query.heights.empty() && !options.wants_heights()) {
    throw std::invalid_argument("--heights: requires --at, the file of positions");
  }
  if (options.scallop_mm > 0.0 &&
      options.scallop_mm < kMinScallopTolerances * options.tolerance_mm) {
    throw std::invalid_argument(
        fmt::format("--scallop: {:g} mm is less than {:g} times the --tolerance of {:g} mm",
                    options.scallop_mm,
                    kMinScallopTolerances,
                    options.tolerance_mm));
  }
  check_line_options(options);
  if (options.mill.slot_feed_mm_min > 0.0 && options.levels.depth_mm == 0.0) {
    throw std::invalid_argument("--slot-feed: only --layers have rows with stock on both sides");
  }
  if (options.levels.depth_mm > 0.0 && options.scallop_mm > 0.0) {
    throw std::invalid_argument(
        "--scallop: the rows of --layers follow --step only; leave --scallop out");
  }
  check_region_options(options.regions, options.file);
  check_smooth(options);
  check_pencil_options(options);
  const char* const instead = options.wants_heights() ? "--at" : "--like-paper";
  check_surface_pictures(options.pictures, options.wants_program() ? nullptr : instead);
  if (!options.wants_program()) {
    for (const auto& [name, file] :
         {std::pair{"--output", &options.output}, std::pair{"--report", &options.report}}) {
      if (file->empty()) continue;
      throw std::invalid_argument(fmt::format("{}: there is no program with {}", name, instead));
    }
    return;
  }
  if (options.mill.feed_mm_min == 0.0)
    throw std::invalid_argument("--feed is missing; give it in mm/min");
  if (options.mill.plunge_mm_min == 0.0) {
    throw std::invalid_argument("--plunge-feed is missing; give it in mm/min");
  }
}

surface::RowOptions row_options_of(const SurfaceCommandOptions& options,
                                   const stock::Cutter& cutter) {
  double step_mm = options.step_mm;
  if (options.paths == SurfacePaths::kRough) {
    step_mm = rough_step_of(options, cutter);
  } else if (step_mm == 0.0 && options.scallop_mm == 0.0) {
    step_mm = 0.1 * cutter.diameter_mm;
  }
  return {.tool = profile_of(cutter),
          .allowance_mm = options.allowance_mm,
          .tolerance_mm = options.tolerance_mm,
          .digit_mm = std::pow(10.0, -static_cast<double>(options.decimals)),
          .step_mm = step_mm,
          .scallop_mm = options.scallop_mm,
          .angle_rad = options.angle_deg.value_or(0.0) * std::numbers::pi / 180.0,
          .margin_mm = options.margin_mm,
          .floor_mm = options.floor_mm,
          .order = options.order.value_or(surface::RowOrder::kZigzag),
          .direction = options.direction,
          .regions = {},
          .stock_top_mm = options.stock.top_mm,
          .layer_mm = options.levels.depth_mm,
          .lines_only = options.lines_only,
          .smooth = {},
          .progress = {}};
}

}  // namespace sim
