#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "host-sim/cli/surface_options.hpp"
#include "host-sim/cli/value_range.hpp"

namespace sim {

void add_pencil_options(CLI::App& command, SurfaceCommandOptions& options) {
  command.add_flag("--pencil",
                   options.pencil.is_wanted,
                   "Mill, in place of rows, one pass along each valley in which the tool touches "
                   "both sides, and\nalong the feet of walls");
  command
      .add_option("--pencil-angle",
                  options.pencil.angle_deg,
                  "Least angle between the normals of the two sides of a valley, degrees")
      ->check(in_range(1.0, 170.0, "degrees"))
      ->type_name("DEG")
      ->capture_default_str();
}

void check_pencil_options(const SurfaceCommandOptions& options) {
  if (!options.pencil.is_wanted) return;
  for (const auto& [name, is_given] : {std::pair{"--step", options.step_mm > 0.0},
                                       std::pair{"--scallop", options.scallop_mm > 0.0},
                                       std::pair{"--layers", options.levels.depth_mm > 0.0},
                                       std::pair{"--angle", options.angle_deg.has_value()},
                                       std::pair{"--margin", options.margin_mm > 0.0},
                                       std::pair{"--order", options.order.has_value()},
                                       std::pair{"--direction", options.direction.has_value()}}) {
    if (!is_given) continue;
    throw std::invalid_argument(
        fmt::format("{}: --pencil has no rows; leave one of them out", name));
  }
}

surface::PencilOptions pencil_options_of(const SurfaceCommandOptions& options,
                                         const stock::Cutter& cutter) {
  return {.angle_rad = options.pencil.angle_deg * std::numbers::pi / 180.0,
          .min_mm = 0.5 * cutter.diameter_mm};
}

}  // namespace sim
