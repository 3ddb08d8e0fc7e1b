#include "host-sim/cut/part_units.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <queue>
#include <utility>

#include "planner/base/contract.hpp"

namespace sim::cut {
namespace {

constexpr std::size_t kNone = SIZE_MAX;

void make_unique(std::vector<std::size_t>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

/// Returns `count` units with their cuts and the precedence between them. `unit_of` has the unit of
/// each cut.
PartUnits gathered(const std::vector<UnbegunCut>& cuts,
                   const std::vector<std::size_t>& members,
                   const std::vector<std::size_t>& unit_of,
                   std::size_t count) {
  PartUnits units{.cuts = std::vector<std::vector<std::size_t>>(count),
                  .after = std::vector<std::vector<std::size_t>>(count)};
  for (const std::size_t member : members) {
    const std::size_t unit = unit_of[member];
    units.cuts[unit].push_back(member);
    for (const std::size_t before : cuts[member].after) {
      const std::size_t other = unit_of[before];
      if (other != kNone && other != unit) units.after[unit].push_back(other);
    }
  }
  for (std::vector<std::size_t>& after : units.after) make_unique(after);
  for (std::vector<std::size_t>& unit : units.cuts) std::ranges::sort(unit);
  return units;
}

/// Returns the units in an order that keeps every precedence. Among the units whose predecessors
/// are done, the unit with the lowest rank is next. Units that wait for each other in a circle, and
/// all units after these, are left out.
std::vector<std::size_t> sorted_units(const PartUnits& units,
                                      const std::vector<std::size_t>& ranks) {
  using Ranked = std::pair<std::size_t, std::size_t>;
  std::vector<std::size_t> waits_for(units.after.size());
  std::vector<std::vector<std::size_t>> followers(units.after.size());
  std::priority_queue<Ranked, std::vector<Ranked>, std::greater<>> ready;
  for (std::size_t i = 0; i < units.after.size(); ++i) {
    waits_for[i] = units.after[i].size();
    for (const std::size_t before : units.after[i]) followers[before].push_back(i);
    if (waits_for[i] == 0) ready.emplace(ranks[i], i);
  }
  std::vector<std::size_t> sorted;
  while (!ready.empty()) {
    const std::size_t unit = ready.top().second;
    ready.pop();
    sorted.push_back(unit);
    for (const std::size_t follower : followers[unit]) {
      if (--waits_for[follower] == 0) ready.emplace(ranks[follower], follower);
    }
  }
  return sorted;
}

}  // namespace

PartUnits units_of(const std::vector<UnbegunCut>& cuts, const std::vector<std::size_t>& members) {
  std::map<std::size_t, std::size_t> unit_of_part;
  std::vector<std::size_t> unit_of(cuts.size(), kNone);
  for (const std::size_t member : members) {
    unit_of[member] = unit_of_part.emplace(cuts[member].part, unit_of_part.size()).first->second;
  }
  PartUnits units = gathered(cuts, members, unit_of, unit_of_part.size());
  const std::vector<std::size_t> none(units.cuts.size(), 0);
  const std::vector<std::size_t> sorted = sorted_units(units, none);
  if (sorted.size() == units.cuts.size()) return units;
  // All units that sorted_units() leaves out become one unit, the last one.
  std::vector<std::size_t> number(units.cuts.size(), sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i) number[sorted[i]] = i;
  for (const std::size_t member : members) unit_of[member] = number[unit_of[member]];
  return gathered(cuts, members, unit_of, sorted.size() + 1);
}

void bring_together(std::vector<OrderedCut>& order, const PartUnits& units) {
  std::map<std::size_t, std::size_t> unit_of;
  for (std::size_t i = 0; i < units.cuts.size(); ++i) {
    for (const std::size_t cut : units.cuts[i]) unit_of[cut] = i;
  }
  std::vector<std::vector<OrderedCut>> rows(units.cuts.size());
  std::vector<std::size_t> ranks(units.cuts.size(), kNone);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t unit = unit_of.at(order[i].cut);
    ranks[unit] = std::min(ranks[unit], i);
    rows[unit].push_back(order[i]);
  }
  std::vector<OrderedCut> together;
  for (const std::size_t unit : sorted_units(units, ranks)) {
    together.insert(together.end(), rows[unit].begin(), rows[unit].end());
  }
  CNC_ASSERT(together.size() == order.size());
  order = std::move(together);
}

}  // namespace sim::cut
