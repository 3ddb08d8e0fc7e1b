#include "host-sim/cut/order_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "host-sim/cut/cut_turn.hpp"
#include "host-sim/cut/group_order.hpp"
#include "host-sim/cut/own_costs.hpp"
#include "host-sim/cut/part_order.hpp"
#include "host-sim/cut/part_units.hpp"
#include "planner/order/set_masks.hpp"

namespace sim::cut {
namespace {

using order::OrderMethod;

constexpr int kRefinementRounds = 20;
constexpr int kRoundsOfMany = 4;
constexpr std::size_t kMany = 20'000;  ///< Number of cuts above which refinement has fewer passes.

RapidCost cost_of(const OrderWish& wish) {
  return wish.cost == OrderCost::kTime ? RapidCost{wish.limits} : RapidCost{};
}

/// Returns groups of indices of cuts. The cuts of a group have the same CutTurn. The groups are in
/// the order of their turns.
std::vector<std::vector<std::size_t>> groups_of(const std::vector<UnbegunCut>& cuts,
                                                Grouping grouping) {
  const std::vector<CutTurn> turns = turns_of(cuts, grouping);
  std::map<CutTurn, std::vector<std::size_t>> sorted;
  for (std::size_t i = 0; i < cuts.size(); ++i) sorted[turns[i]].push_back(i);
  std::vector<std::vector<std::size_t>> groups;
  groups.reserve(sorted.size());
  for (auto& [turn, members] : sorted) groups.push_back(std::move(members));
  return groups;
}

/// Orders the cuts of one group, which have the same CutTurn. The cuts of each part stay together
/// if the user requires it.
GroupResult order_turn(const std::vector<UnbegunCut>& cuts,
                       const std::vector<std::size_t>& members,
                       const RapidCost& cost,
                       const GroupTask& task,
                       const OrderWish& wish) {
  if (wish.grouping != Grouping::kPart) {
    return order_group(cuts, members, cost, task, wish.progress);
  }
  if (task.method == OrderMethod::kOurs) {
    return order_parts(cuts, members, cost, task, wish.progress);
  }
  GroupResult result = order_group(cuts, members, cost, task, wish.progress);
  bring_together(result.cuts, units_of(cuts, members));
  result.is_proven = false;
  return result;
}

ChosenOrder order_groups(const std::vector<UnbegunCut>& cuts,
                         const OrderWish& wish,
                         OrderMethod method,
                         bool only_usual,
                         const std::vector<OrderedCut>& start) {
  const RapidCost cost = cost_of(wish);
  const auto groups = groups_of(cuts, wish.grouping);
  ChosenOrder chosen{.cuts = {}, .is_proven = groups.size() == 1};
  Place here = wish.from;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    GroupTask task{.method = method, .only_usual = only_usual, .from = here, .seed = wish.seed};
    if (i + 1 == groups.size()) task.to = wish.to;
    if (groups.size() == 1) task.start = start;
    if (wish.seconds) {
      task.seconds =
          *wish.seconds * static_cast<double>(groups[i].size()) / static_cast<double>(cuts.size());
    }
    GroupResult result = order_turn(cuts, groups[i], cost, task, wish);
    chosen.is_proven = chosen.is_proven && result.is_proven;
    if (!result.cuts.empty()) here = result.cuts.back().beginning.exit;
    chosen.cuts.insert(chosen.cuts.end(), result.cuts.begin(), result.cuts.end());
  }
  return chosen;
}

double sum_of(const std::vector<OrderedCut>& order, const RapidCost& cost, const JobEnds& ends) {
  Place here = ends.from;
  double sum = 0.0;
  for (const OrderedCut& ordered : order) {
    const Place way = ordered.beginning.entry - here;
    sum += cost(way.x(), way.y());
    here = ordered.beginning.exit;
  }
  return sum + cost(ends.to.x() - here.x(), ends.to.y() - here.y());
}

/// Repeats the search with the refined beginnings added to the lists of beginnings, while this
/// lowers the cost.
void search_again(ChosenOrder& chosen,
                  const std::vector<UnbegunCut>& cuts,
                  const OrderWish& wish,
                  const Clearance& edges) {
  constexpr int kAgain = 2;
  const RapidCost cost = cost_of(wish);
  const JobEnds ends{wish.from, wish.to};
  for (int i = 0; i < kAgain; ++i) {
    std::vector<UnbegunCut> more = cuts;
    for (const OrderedCut& ordered : chosen.cuts) {
      if (!more[ordered.cut].may_move) continue;
      UnbegunCut& cut = more[ordered.cut];
      if (!cut.own_cost.empty()) cut.own_cost.push_back(own_cost_at(cut, ordered.beginning));
      cut.beginnings.push_back(ordered.beginning);
    }
    ChosenOrder next = order_groups(more, wish, OrderMethod::kOurs, false, chosen.cuts);
    refine_beginnings(next.cuts, cuts, cost, ends, edges, kRefinementRounds);
    if (cost_along(next.cuts, cuts, cost, ends) >= cost_along(chosen.cuts, cuts, cost, ends))
      return;
    chosen.cuts = std::move(next.cuts);
  }
}

}  // namespace

RapidSum rapids_of(const std::vector<OrderedCut>& order,
                   const std::vector<UnbegunCut>& cuts,
                   const OrderWish& wish) {
  const JobEnds ends{wish.from, wish.to};
  const RapidCost time{wish.limits};
  double own = 0.0;
  for (const OrderedCut& ordered : order) own += own_cost_at(cuts[ordered.cut], ordered.beginning);
  return {sum_of(order, RapidCost{}, ends),
          sum_of(order, time, ends) / time.mm_per_s(),
          own / time.mm_per_s()};
}

std::vector<OrderedCut> usual_order(const std::vector<UnbegunCut>& cuts,
                                    const OrderWish& wish,
                                    OrderMethod method) {
  OrderWish plain = wish;
  plain.grouping = Grouping::kNone;
  plain.progress = {};
  return order_groups(cuts, plain, method, true, {}).cuts;
}

ChosenOrder choose_order(const std::vector<UnbegunCut>& cuts,
                         const OrderWish& wish,
                         const Clearance& edges) {
  if (wish.method == OrderMethod::kExact && cuts.size() > cnc::order::kMaxMaskedSets) {
    throw std::invalid_argument(
        fmt::format("--order exact: {} cuts are too many for a proof, at most {}; use --order ours",
                    cuts.size(),
                    cnc::order::kMaxMaskedSets));
  }
  const JobEnds ends{wish.from, wish.to};
  ChosenOrder chosen;
  try {
    chosen = order_groups(cuts, wish, wish.method, false, {});
  } catch (const order::NoOrder&) {
    throw std::invalid_argument(
        "--order exact: the proof does not fit into 1 GB; use --order ours, which needs none");
  }
  chosen.listed = rapids_of(chosen.cuts, cuts, wish);
  if (wish.method == OrderMethod::kNearest || wish.method == OrderMethod::kAnneal) return chosen;
  const RapidCost cost = cost_of(wish);
  const int rounds = cuts.size() > kMany ? kRoundsOfMany : kRefinementRounds;
  choose_beginnings(chosen.cuts, cuts, cost, ends);
  chosen.listed = rapids_of(chosen.cuts, cuts, wish);
  refine_beginnings(chosen.cuts, cuts, cost, ends, edges, rounds);
  const bool is_whole = wish.grouping != Grouping::kPart && cuts.size() <= kMany;
  if (wish.method == OrderMethod::kOurs && is_whole && !wish.seconds) {
    search_again(chosen, cuts, wish, edges);
  }
  return chosen;
}

}  // namespace sim::cut
