#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <stdexcept>
#include <utility>

#include "host-sim/cli/cutter_text.hpp"
#include "host-sim/cli/surface_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/surface/path/rough_path.hpp"

namespace sim {

void add_rough_options(CLI::App& command, SurfaceCommandOptions& options) {
  command
      .add_option(
          "--stock-margin",
          options.stock.margin_mm,
          "Distance from the surface's box to the edge of the stock, mm: --paths rough then "
          "comes in from\noutside the stock; default: from above")
      ->check(in_range(0.0, 1000.0, "mm"))
      ->type_name("MM");
}

void check_rough_options(const SurfaceCommandOptions& options) {
  if (options.levels.depth_mm == 0.0) {
    throw std::invalid_argument("--paths rough: requires the depth of its levels; give --layers");
  }
  for (const auto& [name, is_given] : {std::pair{"--slope", !options.regions.slope.empty()},
                                       std::pair{"--rest-of", !options.regions.rest_of.empty()},
                                       std::pair{"--scallop", options.scallop_mm > 0.0}}) {
    if (!is_given) continue;
    throw std::invalid_argument(fmt::format(
        "{}: is not possible with --paths rough; leave it out, or take --paths rows", name));
  }
  if (options.stock.margin_mm && options.margin_mm > 0.0) {
    throw std::invalid_argument(
        "--margin: with --stock-margin the tool goes as far as required; leave one out");
  }
}

double rough_step_of(const SurfaceCommandOptions& options, const stock::Cutter& cutter) {
  // Default step-over as a share of the tool's clearing radius.
  constexpr double kUsualShare = 0.8;
  const double clearing_mm = surface::clearing_radius(profile_of(cutter), options.levels.depth_mm);
  if (options.step_mm == 0.0) return kUsualShare * clearing_mm;
  if (options.step_mm <= 2.0 * clearing_mm) return options.step_mm;
  throw std::invalid_argument{
      fmt::format("--step: {:g} mm is more than the {:g} mm that the tool clears half a layer "
                  "above its tip; take a smaller one",
                  options.step_mm,
                  2.0 * clearing_mm)};
}

}  // namespace sim
