#include "host-sim/cut/safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host-sim/cut/cooling.hpp"
#include "host-sim/cut/link_cuts.hpp"
#include "host-sim/cut/route_rapids.hpp"
#include "host-sim/cut/slice_waste.hpp"

namespace sim::cut {
namespace {

CoolingRules cooling_of(const CutPlan& plan, const SafetyWishes& wishes) {
  double widest_mm = 1.0e-3;
  for (const Cut& cut : plan.cuts) {
    widest_mm = std::max(widest_mm, plan.plan_of(cut).condition.kerf_mm);
  }
  const bool is_given = wishes.cool_distance_mm > 0.0;
  return {wishes.cool_s,
          is_given ? wishes.cool_distance_mm : kCoolKerfs * widest_mm,
          plan.order.wish.limits};
}

SliceRules slices_of(const drawing::Drawing& drawn, const SafetyWishes& wishes) {
  SliceRules rules{.piece_mm = wishes.slice_mm, .margin_mm = wishes.slice_margin_mm};
  if (!drawn.stock) return rules;
  if (drawn.stock->keeps_skeleton) {
    throw std::invalid_argument(
        "--slice: the sheet file requires that the rest of the stock stays in one piece; leave out "
        "--slice or \"skeleton\"");
  }
  rules.stock = LoopArea::Box{0.0, 0.0, drawn.stock->width_mm, drawn.stock->height_mm};
  return rules;
}

}  // namespace

void make_safe(CutPlan& plan, const drawing::Drawing& drawn, const SafetyWishes& wishes) {
  const bool cools = wishes.cool_s > 0.0;
  if (cools) reorder_for_cooling(plan, cooling_of(plan, wishes));
  if (wishes.slice_mm > 0.0) {
    slice_waste(plan, drawn, slices_of(drawn, wishes));
  }
  if (wishes.chain_mm > 0.0) {
    link_cuts(plan, drawn, {.longest_mm = wishes.chain_mm, .limits = plan.order.wish.limits});
  }
  if (wishes.avoid_freed) {
    route_rapids(plan, drawn, {.margin_mm = wishes.avoid_margin_mm, .lift_mm = wishes.lift_mm});
  }
  // The waits come last, because a cut with a link needs no wait, and a routed rapid takes more
  // time.
  if (cools) wait_for_cooling(plan, cooling_of(plan, wishes));
}

std::vector<std::string> lines_of(const SafetyFigures& figures) {
  std::vector<std::string> lines;
  if (figures.avoids_freed) {
    lines.push_back(fmt::format("{} rapids routed around freed areas, {:.1f} mm longer; {} lifted",
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
  if (figures.chains) {
    lines.push_back(fmt::format("{} pierces saved by links, {:.1f} mm long in all; {:.1f} s saved",
                                figures.links,
                                figures.links_mm,
                                figures.links_s));
  }
  if (figures.slices_waste) {
    lines.push_back(
        fmt::format("{} cuts through the waste, {:.1f} mm", figures.slices, figures.slices_mm));
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
          {"moved_forward", figures.cooling_swaps},
          {"chains", figures.chains},
          {"pierces_saved", figures.links},
          {"links_mm", figures.links_mm},
          {"links_saved_s", figures.links_s},
          {"slices_waste", figures.slices_waste},
          {"slices", figures.slices},
          {"slices_mm", figures.slices_mm}};
}

}  // namespace sim::cut
