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
    "Carves a block as the beams burn it: all that is within a beam's cone above its tip, and the\n"
    "waist down to --depth below it. For each wall of FILE it prints a place, the drawn angle and\n"
    "the carved one, degrees from the vertical, above 0 where the part is wider below.\n"
    "\n"
    "Example:\n"
    "  kerfline wall carve part.stl --beams beams.txt --half-angle 7 --cell 0.006\n"
    "    --section 0,1,3,1 --picture-section section.png --carved carved.stl";

void add_carve_files(CLI::App& command, CarveOptions& options) {
  mark_file(command.add_option("FILE", options.file, "The part: a closed mesh")->required(),
            FileRole::kInput);
  mark_file(command
                .add_option("--beams",
                            options.beams,
                            "Beams in the order of their path, `x y z i j k` on each line; a blank "
                            "line\ninterrupts them")
                ->required()
                ->type_name("FILE"),
            FileRole::kInput);
  mark_file(command
                .add_option("--beside",
                            options.beside,
                            "Other beams for the same part, to be compared: a block of their own")
                ->type_name("FILE"),
            FileRole::kInput);
  mark_file(command
                .add_option("--carved",
                            options.carved,
                            "What --beams leave, as binary STL, or PLY where it ends in .ply")
                ->type_name("FILE"),
            FileRole::kOutput);
  mark_file(command
                .add_option("--picture-section",
                            options.picture,
                            "The section of each block and of the part: PNG where it ends in .png, "
                            "else SVG")
                ->type_name("FILE"),
            FileRole::kOutput);
  mark_file(command
                .add_option(
                    "-o,--output", options.output, "Where to write the walls; else standard output")
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
                  "Between the axis and the side of the beam, degrees")
      ->required()
      ->check(in_range(0.5, 80.0, "degrees"))
      ->type_name("DEG");
  command
      .add_option("--heat", options.heat_deg, "By which heat widens the cone on each side, degrees")
      ->check(in_range(0.0, 60.0, "degrees"))
      ->type_name("DEG")
      ->capture_default_str();
  command.add_option("--waist", options.waist_mm, "Radius of the beam at its tip")
      ->check(in_range(0.0, 10.0, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option(
          "--depth", options.depth_mm, "Burned below the tip in a pass, as wide as the waist")
      ->check(in_range(0.0, 10.0, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command.add_option("--cell", options.cell_mm, "Side of the stock's columns")
      ->check(in_range(0.001, 10.0, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option("--around",
                  options.around_mm,
                  "By which the stock is wider than part and tips on each side")
      ->check(in_range(0.0, 1000.0, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option("--section", options.section, "Ends of the section in the plan, for its picture")
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
        fmt::format("--heat: {:g} degrees beside a half angle of {:g} are no cone; 85 are the most",
                    options.heat_deg,
                    options.half_angle_deg));
  }
  if (options.depth_mm > 0.0 && options.waist_mm == 0.0) {
    throw std::invalid_argument("--depth: a beam without a width burns no depth; add --waist");
  }
  if (options.picture.empty() != options.section.empty()) {
    throw std::invalid_argument("--section and --picture-section need each other");
  }
  if (options.picture.empty()) return;
  require_picture_name("--picture-section", options.picture);
  for (const double place : options.section) {
    if (!(std::abs(place) <= surface::kFarthestMm)) {
      throw std::invalid_argument("--section: its ends are within 10 m of zero");
    }
  }
  if (!(options.section_line().length_mm() > 1.0e-6)) {
    throw std::invalid_argument("--section: its ends are one point; give two");
  }
}

}  // namespace sim
