#include "host-sim/cli/cut_safety_options.hpp"

#include <CLI/CLI.hpp>

#include "host-sim/cli/cut_options.hpp"
#include "host-sim/cli/value_range.hpp"

namespace sim {
namespace {

constexpr double kShortestMm = 0.01;
constexpr double kMaxMarginMm = 100.0;
constexpr double kMaxLiftMm = 1000.0;

}  // namespace

void add_cut_safety_options(CLI::App& command, const std::shared_ptr<CutCommandOptions>& options) {
  cut::SafetyWishes& safety = options->safety;
  CLI::Option* const avoid = command.add_flag(
      "--avoid-freed", safety.avoid_freed, "Lead rapids round holes and parts that are cut free");
  command
      .add_option("--avoid-margin",
                  safety.avoid_margin_mm,
                  "Distance of these rapids from the kerf, where there is room")
      ->check(in_range(kShortestMm, kMaxMarginMm, "mm"))
      ->capture_default_str()
      ->needs(avoid)
      ->type_name("MM");
  command.add_option("--lift", safety.lift_mm, "Z of rapids that find no way round; else a fault")
      ->check(in_range(kShortestMm, kMaxLiftMm, "mm"))
      ->needs(avoid)
      ->type_name("MM");
}

}  // namespace sim
