#include "host-sim/cut/part_order.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "host-sim/cut/part_units.hpp"

namespace sim::cut {
namespace {

constexpr int kPartRounds = 4;
/// Number of units above which the search has only one pass, because each pass takes long.
constexpr std::size_t kManyUnits = 5'000;
/// Number of search steps for the order within a part, per cut of the part.
constexpr std::uint64_t kStepsOfCut = 100;

/// A path through all cuts of a part, given by the number of a beginning of the first cut and of a
/// beginning of the last cut.
struct PartWay {
  std::size_t first = 0;
  std::size_t last = 0;
  double cost = 0.0;  ///< Cost of all cuts and of the rapids between them.
};

double cost_of_leg(const RapidCost& cost, const Beginning& from, const Beginning& to) {
  return cost(to.entry.x() - from.exit.x(), to.entry.y() - from.exit.y());
}

/// Returns, for each beginning of the last cut, the cheapest path that ends with this beginning.
/// The order of the cuts does not change.
std::vector<PartWay> ways_to_last(const std::vector<const UnbegunCut*>& row,
                                  const RapidCost& cost) {
  std::vector<PartWay> ways;
  for (std::size_t i = 0; i < row.front()->beginnings.size(); ++i) {
    ways.push_back({i, i, row.front()->own_cost_of(i)});
  }
  for (std::size_t k = 1; k < row.size(); ++k) {
    std::vector<PartWay> next;
    for (std::size_t i = 0; i < row[k]->beginnings.size(); ++i) {
      const auto cost_from = [&](const PartWay& way) {
        return way.cost +
               cost_of_leg(cost, row[k - 1]->beginnings[way.last], row[k]->beginnings[i]);
      };
      const PartWay best = *std::ranges::min_element(ways, {}, cost_from);
      next.push_back({best.first, i, cost_from(best) + row[k]->own_cost_of(i)});
    }
    ways = std::move(next);
  }
  return ways;
}

/// Returns, for each beginning of the first cut, the cheapest path that starts with this beginning.
/// The order of the cuts does not change.
std::vector<PartWay> ways_from_first(const std::vector<const UnbegunCut*>& row,
                                     const RapidCost& cost) {
  std::vector<PartWay> ways;
  for (std::size_t i = 0; i < row.back()->beginnings.size(); ++i) {
    ways.push_back({i, i, row.back()->own_cost_of(i)});
  }
  for (std::size_t k = row.size() - 1; k-- > 0;) {
    std::vector<PartWay> before;
    for (std::size_t i = 0; i < row[k]->beginnings.size(); ++i) {
      const auto cost_to = [&](const PartWay& way) {
        return way.cost +
               cost_of_leg(cost, row[k]->beginnings[i], row[k + 1]->beginnings[way.first]);
      };
      const PartWay best = *std::ranges::min_element(ways, {}, cost_to);
      before.push_back({i, best.last, cost_to(best) + row[k]->own_cost_of(i)});
    }
    ways = std::move(before);
  }
  return ways;
}

class PartSearch {
 public:
  PartSearch(const std::vector<UnbegunCut>& cuts,
             const std::vector<std::size_t>& members,
             const RapidCost& cost,
             const GroupTask& task)
      : cuts_{cuts}, members_{members}, cost_{cost}, task_{task}, units_{units_of(cuts, members)} {}

  GroupResult run(const order::OrderProgress& progress) {
    std::vector<OrderedCut> best = searched_apart(progress);
    double least = cost_along(best, cuts_, cost_, ends_of(best));
    const int rounds = units_.cuts.size() > kManyUnits ? 1 : kPartRounds;
    for (const bool starts_apart : {true, false}) {
      rows_ = starts_apart ? rows_of(best) : rows_from_start();
      for (int round = 0; round < rounds; ++round) {
        order_units(progress);
        order_within();
        std::vector<OrderedCut> found = whole();
        const double found_cost = cost_along(found, cuts_, cost_, ends_of(found));
        if (found_cost >= least) break;
        best = std::move(found);
        least = found_cost;
      }
    }
    return {std::move(best), false};
  }

 private:
  [[nodiscard]] JobEnds ends_of(const std::vector<OrderedCut>& order) const {
    return {task_.from, task_.to.value_or(order.back().beginning.exit)};
  }

  /// Orders all cuts as if they belonged to no parts, then brings the cuts of each unit together.
  [[nodiscard]] std::vector<OrderedCut> searched_apart(const order::OrderProgress& progress) const {
    GroupTask task = task_;
    task.start = {};
    if (task_.seconds) task.seconds = 0.5 * *task_.seconds;
    std::vector<OrderedCut> order = order_group(cuts_, members_, cost_, task, progress).cuts;
    bring_together(order, units_);
    choose_beginnings(order, cuts_, cost_, ends_of(order));
    return order;
  }

  /// Returns the order of the cuts of each unit within an order of all cuts.
  [[nodiscard]] std::vector<std::vector<OrderedCut>> rows_of(
      const std::vector<OrderedCut>& order) const {
    std::vector<std::size_t> unit_of(cuts_.size());
    for (std::size_t i = 0; i < units_.cuts.size(); ++i) {
      for (const std::size_t cut : units_.cuts[i]) unit_of[cut] = i;
    }
    std::vector<std::vector<OrderedCut>> rows(units_.cuts.size());
    for (const OrderedCut& ordered : order) rows[unit_of[ordered.cut]].push_back(ordered);
    return rows;
  }
  /// Orders the cuts of each unit as if the unit were the first one of the job.
  [[nodiscard]] std::vector<std::vector<OrderedCut>> rows_from_start() const {
    std::vector<std::vector<OrderedCut>> rows;
    for (const std::vector<std::size_t>& unit : units_.cuts) {
      rows.push_back(searched(unit, task_.from, std::nullopt));
    }
    return rows;
  }

  /// Orders the cuts of one unit, between two points.
  [[nodiscard]] std::vector<OrderedCut> searched(const std::vector<std::size_t>& unit,
                                                 const Place& from,
                                                 const std::optional<Place>& to) const {
    if (unit.size() == 1) return {{unit.front(), cuts_[unit.front()].beginnings.front()}};
    GroupTask task{.from = from, .to = to, .seed = task_.seed};
    task.steps = std::min(usual_steps(unit.size(), unit.size()), kStepsOfCut * unit.size());
    return order_group(cuts_, unit, cost_, task, {}).cuts;
  }

  void order_units(const order::OrderProgress& progress);
  void order_within();
  [[nodiscard]] UnbegunCut stand_in(std::size_t unit) const;
  [[nodiscard]] std::vector<OrderedCut> whole() const;

  const std::vector<UnbegunCut>& cuts_;
  const std::vector<std::size_t>& members_;
  const RapidCost& cost_;
  const GroupTask& task_;
  PartUnits units_;
  std::vector<std::vector<OrderedCut>> rows_;  ///< Order of the cuts within each unit.
  /// Order of the units, each with the ends of its path.
  std::vector<OrderedCut> sequence_;
};

/// Returns a cut that represents a unit. Its beginnings have the entries and exits of the possible
/// paths through the unit.
UnbegunCut PartSearch::stand_in(std::size_t unit) const {
  UnbegunCut cut{.path = MeasuredRow{{}}, .settings = {}};
  cut.after = units_.after[unit];
  cut.may_move = false;
  std::vector<const UnbegunCut*> row;
  for (const OrderedCut& ordered : rows_[unit]) row.push_back(&cuts_[ordered.cut]);
  std::vector<PartWay> ways = ways_to_last(row, cost_);
  if (row.size() > 1) {
    const std::vector<PartWay> more = ways_from_first(row, cost_);
    ways.insert(ways.end(), more.begin(), more.end());
  }
  const double least = std::ranges::min(ways, {}, &PartWay::cost).cost;
  for (const PartWay& way : ways) {
    cut.beginnings.push_back({.way_mm = static_cast<double>(cut.beginnings.size()),
                              .entry = row.front()->beginnings[way.first].entry,
                              .exit = row.back()->beginnings[way.last].exit});
    cut.own_cost.push_back(way.cost - least);
  }
  return cut;
}

void PartSearch::order_units(const order::OrderProgress& progress) {
  std::vector<UnbegunCut> units;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < units_.cuts.size(); ++i) {
    units.push_back(stand_in(i));
    numbers.push_back(i);
  }
  GroupTask task{.method = task_.method, .from = task_.from, .to = task_.to, .seed = task_.seed};
  if (task_.seconds) task.seconds = 0.25 * *task_.seconds / kPartRounds;
  sequence_ = order_group(units, numbers, cost_, task, progress).cuts;
}

/// Repeats the search for the order within each unit, between the ends of the neighbouring units.
void PartSearch::order_within() {
  for (std::size_t i = 0; i < sequence_.size(); ++i) {
    std::vector<OrderedCut>& row = rows_[sequence_[i].cut];
    if (row.size() == 1) continue;
    const bool is_last = i + 1 == sequence_.size();
    const Place from = i == 0 ? task_.from : sequence_[i - 1].beginning.exit;
    const std::optional<Place> to = is_last ? task_.to : sequence_[i + 1].beginning.entry;
    std::vector<OrderedCut> tried = searched(units_.cuts[sequence_[i].cut], from, to);
    const auto min_cost = [&](std::vector<OrderedCut>& order) {
      const JobEnds ends{from, to.value_or(sequence_[i].beginning.exit)};
      choose_beginnings(order, cuts_, cost_, ends);
      return cost_along(order, cuts_, cost_, ends);
    };
    if (min_cost(tried) < min_cost(row)) row = std::move(tried);
  }
}

/// Returns the order of all cuts, with the best beginnings along it.
std::vector<OrderedCut> PartSearch::whole() const {
  std::vector<OrderedCut> order;
  for (const OrderedCut& unit : sequence_) {
    order.insert(order.end(), rows_[unit.cut].begin(), rows_[unit.cut].end());
  }
  choose_beginnings(order, cuts_, cost_, ends_of(order));
  return order;
}

}  // namespace

GroupResult order_parts(const std::vector<UnbegunCut>& cuts,
                        const std::vector<std::size_t>& members,
                        const RapidCost& cost,
                        const GroupTask& task,
                        const order::OrderProgress& progress) {
  if (members.empty()) return {};
  return PartSearch{cuts, members, cost, task}.run(progress);
}

}  // namespace sim::cut
