#include "host-sim/cut/rapid_way.hpp"

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

double rapid_length(const CutPlan& plan) {
  double sum = 0.0;
  for (std::size_t i = 0; i <= plan.cuts.size(); ++i) {
    const std::vector<Place> way = rapid_before(plan, i);
    for (std::size_t k = 1; k < way.size(); ++k) sum += drawing::distance(way[k - 1], way[k]);
  }
  return sum;
}

}  // namespace sim::cut
