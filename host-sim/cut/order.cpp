#include "host-sim/cut/order.hpp"

#include <limits>

#include "planner/base/contract.hpp"

namespace sim::cut {

std::vector<Cut> in_order(std::vector<Cut> cuts) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> waits_for(cuts.size());
  std::vector<std::vector<std::size_t>> awaited_by(cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    waits_for[i] = cuts[i].after.size();
    for (const std::size_t before : cuts[i].after) awaited_by[before].push_back(i);
  }
  std::vector<std::size_t> ready;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    if (waits_for[i] == 0) ready.push_back(i);
  }
  std::vector<std::size_t> order;
  std::vector<std::size_t> number(cuts.size(), kNone);
  Place here{0.0, 0.0};
  while (!ready.empty()) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < ready.size(); ++i) {
      if (drawing::distance(here, cuts[ready[i]].start()) <
          drawing::distance(here, cuts[ready[nearest]].start())) {
        nearest = i;
      }
    }
    const std::size_t next = ready[nearest];
    ready.erase(ready.begin() + static_cast<std::ptrdiff_t>(nearest));
    number[next] = order.size();
    order.push_back(next);
    here = cuts[next].end();
    for (const std::size_t waiting : awaited_by[next]) {
      if (--waits_for[waiting] == 0) ready.push_back(waiting);
    }
  }
  CNC_ASSERT(order.size() == cuts.size());
  std::vector<Cut> result;
  for (const std::size_t index : order) {
    result.push_back(std::move(cuts[index]));
    for (std::size_t& before : result.back().after) before = number[before];
  }
  return result;
}

double rapid_length(const std::vector<Cut>& cuts) {
  Place here{0.0, 0.0};
  double sum = 0.0;
  for (const Cut& cut : cuts) {
    sum += drawing::distance(here, cut.start());
    here = cut.end();
  }
  return sum + drawing::distance(here, {0.0, 0.0});
}

}  // namespace sim::cut
