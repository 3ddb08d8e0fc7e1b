#include "host-sim/cut/rapid_way.hpp"

#include "planner/order/rapid_time.hpp"

namespace sim::cut {

const Place& rapid_end(const Cut& cut) {
  return cut.programmed.empty() ? cut.start() : cut.programmed.front().from;
}

const Place& beam_end(const Cut& cut) {
  return cut.programmed.empty() ? cut.end() : cut.programmed.back().to;
}

std::vector<Place> rapid_before(const CutPlan& plan, std::size_t cut) {
  const bool is_last = cut == plan.cuts.size();
  std::vector<Place> way{cut == 0 ? plan.order.wish.from : beam_end(plan.cuts[cut - 1])};
  const std::vector<Place>& corners = is_last ? plan.way_home : plan.cuts[cut].approach;
  way.insert(way.end(), corners.begin(), corners.end());
  way.push_back(is_last ? plan.order.wish.to : rapid_end(plan.cuts[cut]));
  return way;
}

RapidSum rapids_of(const CutPlan& plan) {
  const cnc::order::RapidTime time{plan.order.wish.limits};
  RapidSum sum;
  for (std::size_t i = 0; i <= plan.cuts.size(); ++i) {
    const std::vector<Place> way = rapid_before(plan, i);
    for (std::size_t k = 1; k < way.size(); ++k) {
      const Place leg = way[k] - way[k - 1];
      sum.length_mm += leg.norm();
      sum.time_s += time(leg.x(), leg.y());
    }
  }
  return sum;
}

double rapid_length(const CutPlan& plan) { return rapids_of(plan).length_mm; }

}  // namespace sim::cut
