#include "host-sim/order/file_order.hpp"

#include <algorithm>

namespace sim::order {

using cnc::order::Index;

std::vector<Index> file_order(const cnc::order::Problem& problem) {
  const Index sets = problem.sets();
  std::vector<Index> waits_for(sets);
  std::vector<Index> order{0};
  std::vector<bool> is_due(sets);
  for (Index set = 1; set < sets; ++set) {
    for (const Index before : problem.precedence.before(set)) waits_for[set] += before != 0 ? 1 : 0;
  }
  std::vector<Index> open;
  for (Index set = 1; set < sets; ++set) {
    is_due[set] = true;
    if (waits_for[set] == 0) open.push_back(set);
    for (std::size_t i = 0; i < open.size(); ++i) {
      order.push_back(open[i]);
      for (const Index after : problem.precedence.after(open[i])) {
        if (--waits_for[after] == 0 && is_due[after]) open.push_back(after);
      }
    }
    open.clear();
  }
  return order;
}

double unit_of(const OrderProblem& problem) {
  double unit = 0.0;
  for (const double cost : problem.matrix) {
    if (cnc::order::is_allowed(cost)) unit = std::max(unit, cost);
  }
  if (!problem.entry.empty()) {
    cnc::order::Place least = problem.entry.front();
    cnc::order::Place most = least;
    for (const auto* places : {&problem.entry, &problem.exit}) {
      for (const auto& place : *places) {
        least = {std::min(least.x, place.x), std::min(least.y, place.y)};
        most = {std::max(most.x, place.x), std::max(most.y, place.y)};
      }
    }
    unit = std::max(most.x - least.x, most.y - least.y);
  }
  return unit > 0.0 ? unit : 1.0;
}

}  // namespace sim::order
