#include "host-sim/cut/safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host-sim/cut/cooling.hpp"
#include "host-sim/cut/route_rapids.hpp"

namespace sim::cut {
namespace {

CoolingRules cooling_of(const CutPlan& plan, const SafetyWishes& wishes) {
  double widest_mm = 1.0e-3;
  for (const Cut& cut : plan.cuts) {
    widest_mm = std::max(widest_mm, plan.layers[cut.layer].condition.kerf_mm);
  }
  const bool is_given = wishes.cool_distance_mm > 0.0;
  return {wishes.cool_s, is_given ? wishes.cool_distance_mm : kCoolKerfs * widest_mm, wishes.rates};
}

}  // namespace

void make_safe(CutPlan& plan, const drawing::Drawing& drawn, const SafetyWishes& wishes) {
  const bool cools = wishes.cool_s > 0.0;
  if (cools) reorder_for_cooling(plan, cooling_of(plan, wishes));
  if (wishes.avoid_freed) {
    route_rapids(plan, drawn, {.margin_mm = wishes.avoid_margin_mm, .lift_mm = wishes.lift_mm});
  }
  // The way of the rapids takes time, too.
  if (cools) wait_for_cooling(plan, cooling_of(plan, wishes));
}

std::vector<std::string> lines_of(const SafetyFigures& figures) {
  std::vector<std::string> lines;
  if (figures.avoids_freed) {
    lines.push_back(fmt::format("{} rapids led round freed areas, {:.1f} mm longer; {} lifted",
                                figures.led_round,
                                figures.longer_mm,
                                figures.lifted));
  }
  if (figures.cools) {
    lines.push_back(fmt::format("cooling: {} waits, {:.3f} s; {} cuts moved forward",
                                figures.waits,
                                figures.waits_s,
                                figures.cooling_swaps));
  }
  return lines;
}

nlohmann::ordered_json json_of(const SafetyFigures& figures) {
  return {{"avoids_freed", figures.avoids_freed},
          {"led_round", figures.led_round},
          {"led_round_longer_mm", figures.longer_mm},
          {"lifted", figures.lifted},
          {"no_way", figures.no_way},
          {"cools", figures.cools},
          {"waits", figures.waits},
          {"waits_s", figures.waits_s},
          {"moved_forward", figures.cooling_swaps}};
}

}  // namespace sim::cut
