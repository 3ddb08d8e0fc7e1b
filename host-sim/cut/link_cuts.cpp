#include "host-sim/cut/link_cuts.hpp"

#include <algorithm>

#include "host-sim/cut/lead.hpp"
#include "host-sim/cut/route_rapids.hpp"
#include "host-sim/cut/waste_map.hpp"

namespace sim::cut {
namespace {

/// Distance that links keep from tabs, in kerfs. A tab holds its part only if the waste at the
/// other end of the tab stays.
constexpr double kKerfsFromTabs = 1.5;

bool may_be_linked(const Cut& cut, const LayerPlan& layer) {
  return layer.settings.side == Side::kWaste && !cut.is_slice && cut.programmed.empty();
}

/// Returns the time that a link saves, s. Acceleration is ignored.
double saved_by(const Stroke& link,
                const Cut& next,
                const LayerPlan& layer,
                const LinkRules& rules) {
  const bool pierces = next.strokes.front().purpose == Purpose::kPierce;
  double saved = min_time(link.from, link.to, rules.limits) - min_time(link, layer);
  if (pierces) {
    Stroke driven = next.strokes.front();
    driven.purpose = Purpose::kLeadIn;
    saved += min_time(next.strokes.front(), layer) - min_time(driven, layer);
  }
  return saved;
}

/// Inserts a link before a cut. The pierce of the cut becomes a piece of the lead-in, or of the
/// contour if there is no lead-in.
void add_link(Cut& next, const Stroke& link) {
  Stroke& first = next.strokes.front();
  if (first.purpose == Purpose::kPierce) {
    first.purpose = Purpose::kContour;
    if (loop_of_cut(next).empty()) first.purpose = Purpose::kLeadIn;
  }
  next.strokes.insert(next.strokes.begin(), link);
}

}  // namespace

void link_cuts(CutPlan& plan, const drawing::Drawing& drawn, const LinkRules& rules) {
  plan.safety.chains = true;
  double widest_mm = 1.0e-3;
  for (const LayerPlan& layer : plan.layers) {
    widest_mm = std::max(widest_mm, layer.condition.kerf_mm);
  }
  const WasteMap waste{plan, drawn, 2.0 * kKerfsFromTabs * widest_mm};
  for (std::size_t i = 1; i < plan.cuts.size(); ++i) {
    const Cut& before = plan.cuts[i - 1];
    Cut& next = plan.cuts[i];
    const LayerPlan& layer = plan.plan_of(next);
    if (before.layer != next.layer) continue;
    if (!may_be_linked(before, plan.plan_of(before)) || !may_be_linked(next, layer)) continue;
    const Stroke link{before.end(), next.start(), 0.0, Purpose::kLink};
    const double length = length_of(link);
    if (length > rules.longest_mm || length < kPierceWayMm) continue;
    const double saved = saved_by(link, next, layer, rules);
    const double kerf = layer.condition.kerf_mm;
    if (saved <= 0.0) continue;
    if (!waste.is_clear(link.from, link.to, 0.5 * kerf - kClearSlackMm, kKerfsFromTabs * kerf)) {
      continue;
    }
    add_link(next, link);
    ++plan.safety.links;
    plan.safety.links_mm += length;
    plan.safety.links_s += saved;
  }
}

}  // namespace sim::cut
