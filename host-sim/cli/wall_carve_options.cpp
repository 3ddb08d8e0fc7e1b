#include "host-sim/cli/wall_carve_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <stdexcept>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/plot/picture_file.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim {
namespace {

constexpr const char* kCarveFooter =
    "Carves a block as the beams burn it: a beam removes its cone above the tip, and its waist "
    "down\n"
    "to --depth below the tip. For each wall of FILE it prints a point, the drawn angle and the\n"
    "carved angle, degrees from the vertical, above 0 where the part is wider below.\n"
    "\n"
    "Example:\n"
    "  kerfline wall carve part.stl --beams beams.txt --half-angle 7 --cell 0.006\n"
    "    --section 0,1,3,1 --picture-section section.png --carved carved.stl";

void add_carve_files(CLI::App& command, CarveOptions& options) {
  mark_file(command.add_option("FILE", options.file, "Closed mesh of the part")->required(),
            FileRole::kInput);
  mark_file(command
                .add_option("--beams",
                            options.beams,
                            "File of beams in the order of the path, `x y z i j k` on each line; a "
                            "blank line\ninterrupts the path")
                ->required()
                ->type_name("FILE"),
            FileRole::kInput);
  mark_file(
      command
          .add_option(
              "--beside",
              options.beside,
              "File of other beams for the same part, which carve a second block for comparison")
          ->type_name("FILE"),
      FileRole::kInput);
  mark_file(command
                .add_option("--carved",
                            options.carved,
                            "Write the stock that --beams leave, as binary STL, or as PLY if the "
                            "name ends in .ply")
                ->type_name("FILE"),
            FileRole::kOutput);
  mark_file(command
                .add_option("--picture-section",
                            options.picture,
                            "Draw the section of each block and of the part, as PNG if the name "
                            "ends in .png, otherwise SVG")
                ->type_name("FILE"),
            FileRole::kOutput);
  mark_file(
      command
          .add_option("-o,--output", options.output, "File of the walls; default: standard output")
          ->type_name("FILE"),
      FileRole::kOutput);
}

void add_carve_numbers(CLI::App& command, CarveOptions& options) {
  command.add_option("--unit", options.unit_mm, "Length of the part's unit, mm: 25.4 is inches")
      ->check(in_range(1.0e-6, 1.0e6, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option("--half-angle",
                  options.half_angle_deg,
                  "Angle between the axis and the side of the beam, degrees")
      ->required()
      ->check(in_range(0.5, 80.0, "degrees"))
      ->type_name("DEG");
  command
      .add_option(
          "--heat", options.heat_deg, "Angle by which heat widens the cone on each side, degrees")
      ->check(in_range(0.0, 60.0, "degrees"))
      ->type_name("DEG")
      ->capture_default_str();
  command.add_option("--waist", options.waist_mm, "Radius of the beam at its tip, mm")
      ->check(in_range(0.0, 10.0, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option("--depth",
                  options.depth_mm,
                  "Depth that a pass burns below the tip, as wide as the waist, mm")
      ->check(in_range(0.0, 10.0, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command.add_option("--cell", options.cell_mm, "Side of the stock's columns, mm")
      ->check(in_range(0.001, 10.0, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option("--around",
                  options.around_mm,
                  "Distance by which the stock is wider than part and tips on each side, mm")
      ->check(in_range(0.0, 1000.0, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option(
          "--section", options.section, "Ends of the section of --picture-section in plan, mm")
      ->expected(4)
      ->delimiter(',')
      ->type_name("X,Y,X,Y");
}

}  // namespace

void add_carve_options(CLI::App& command, CarveOptions& options) {
  command.footer(kCarveFooter);
  add_carve_files(command, options);
  add_carve_numbers(command, options);
}

void check_carve_options(const CarveOptions& options) {
  if (options.half_angle_deg + options.heat_deg > 85.0) {
    throw std::invalid_argument(
        fmt::format("--heat: {:g} degrees with a half angle of {:g} exceed 85 degrees; choose less",
                    options.heat_deg,
                    options.half_angle_deg));
  }
  if (options.depth_mm > 0.0 && options.waist_mm == 0.0) {
    throw std::invalid_argument("--depth: a beam without a waist burns no depth; add --waist");
  }
  if (options.picture.empty() != options.section.empty()) {
    throw std::invalid_argument("--section and --picture-section require each other; give both");
  }
  if (options.picture.empty()) return;
  require_picture_name("--picture-section", options.picture);
  for (const double place : options.section) {
    if (!(std::abs(place) <= surface::kFarthestMm)) {
      throw std::invalid_argument("--section: both ends must be within 10 m of zero");
    }
  }
  if (!(options.section_line().length_mm() > 1.0e-6)) {
    throw std::invalid_argument("--section: both ends are one point; give two points");
  }
}

}  // namespace sim
