#include "host-sim/cli/cut_safety_options.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <string>

#include "firmware/machine/settings.hpp"
#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cli/value_range.hpp"

namespace sim {
namespace {

constexpr double kShortestMm = 0.01;
constexpr double kMaxDistanceMm = 100.0;
constexpr double kMaxLengthMm = 10'000.0;
constexpr double kMaxCoolS = 3600.0;

}  // namespace

void add_cut_safety_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options) {
  cut::SafetyWishes& safety = options->safety;
  const auto add = [&](const char* name, double& value, double most, const char* help) {
    return command.add_option(name, value, help)
        ->check(in_range(kShortestMm, most, "mm"))
        ->type_name("MM");
  };
  CLI::Option* const avoid =
      command.add_flag("--avoid-freed",
                       safety.avoid_freed,
                       "Route rapids around holes and parts that were cut free");
  add("--avoid-margin",
      safety.avoid_margin_mm,
      kMaxDistanceMm,
      "Distance of these rapids from kerfs and holes where space permits, mm; default: 0.1")
      ->needs(avoid);
  add("--lift",
      safety.lift_mm,
      1000.0,
      "Z of rapids that have no path around holes and parts, mm; default: such a rapid is a fault")
      ->needs(avoid);
  CLI::Option* const cool =
      command
          .add_option("--cool",
                      safety.cool_s,
                      "Least time between a cut and a pierce near it, s: kept by a different order "
                      "of cuts where that is quicker, otherwise by waiting")
          ->check(in_range(0.001, kMaxCoolS, "s"))
          ->type_name("S");
  add("--cool-distance",
      safety.cool_distance_mm,
      kMaxLengthMm,
      "Distance up to which --cool counts a cut as near, mm; default: five kerfs")
      ->needs(cool);
  add("--chain",
      safety.chain_mm,
      kMaxLengthMm,
      "Greatest length of a link through the waste that joins two cuts where that is quicker, mm; "
      "default: no links");
  CLI::Option* const slice = add("--slice",
                                 safety.slice_mm,
                                 kMaxLengthMm,
                                 "Size of the pieces into which the waste is cut at the end, mm");
  command
      .add_option("--slice-margin",
                  safety.slice_margin_mm,
                  "Width of the strip of sheet around all cuts, mm; default: 5")
      ->check(in_range(0.0, kMaxLengthMm, "mm"))
      ->needs(slice)
      ->type_name("MM");
}

}  // namespace sim
