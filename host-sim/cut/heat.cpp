#include "host-sim/cut/heat.hpp"

#include <cmath>

namespace sim::cut {
namespace {

/// Age of a pierce, in multiples of kHeatFadesInS, after which its heat is no longer visible.
constexpr double kMaxFadings = 5.0;

bool is_pierced(const Cut& cut) { return cut.strokes.front().purpose != Purpose::kLink; }

/// Returns the time at which each cut begins, s, after the rapid and the wait before it.
std::vector<double> pierce_times(const CutPlan& plan, const Timeline& timeline) {
  std::vector<double> times(plan.cuts.size(), 0.0);
  for (std::size_t i = timeline.steps.size(); i-- > 0;) {
    const TimeStep& step = timeline.steps[i];
    const bool is_before = step.kind == TimeKind::kRapid || step.kind == TimeKind::kWait;
    if (step.cut < times.size() && !is_before) times[step.cut] = step.begin_s;
  }
  return times;
}

}  // namespace

std::vector<double> heat_at_pierces(const CutPlan& plan, const Timeline& timeline) {
  const std::vector<double> times = pierce_times(plan, timeline);
  std::vector<double> heat(plan.cuts.size(), 0.0);
  for (std::size_t i = 0; i < heat.size(); ++i) {
    for (std::size_t j = i; j-- > 0;) {
      const double age = (times[i] - times[j]) / kHeatFadesInS;
      if (age > kMaxFadings) break;
      if (!is_pierced(plan.cuts[i]) || !is_pierced(plan.cuts[j])) continue;
      const double away =
          drawing::distance(plan.cuts[i].start(), plan.cuts[j].start()) / kHeatFadesInMm;
      heat[i] += std::exp(-age - away * away);
    }
  }
  return heat;
}

}  // namespace sim::cut
