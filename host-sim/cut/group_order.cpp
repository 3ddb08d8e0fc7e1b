#include "host-sim/cut/group_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "host-sim/order/order_run.hpp"

namespace sim::cut {
namespace {

using cnc::order::Index;

cnc::order::Place plain(const Place& place) { return {place.x(), place.y()}; }

/// The problem of ordering one group of cuts, with the beginning that belongs to each candidate.
class GroupProblem {
 public:
  GroupProblem(const std::vector<UnbegunCut>& cuts,
               const std::vector<std::size_t>& members,
               const RapidCost& cost,
               const GroupTask& task)
      : cuts_{cuts}, members_{members}, cost_{cost}, task_{task} {
    add_home();
    for (const std::size_t member : members) add_cut(cuts[member]);
    add_pairs();
  }

  [[nodiscard]] GroupResult solve(const order::OrderProgress& progress);

 private:
  void add_home();
  void add_cut(const UnbegunCut& cut);
  void add_pairs();
  [[nodiscard]] order::OrderResult run(const order::OrderProblem& problem,
                                       bool is_symmetric,
                                       const order::OrderOptions& options,
                                       const order::OrderProgress& progress) const;
  [[nodiscard]] order::OrderProblem made_symmetric() const;
  void begin_with(const std::vector<OrderedCut>& start, order::OrderOptions& options) const;
  static void begin_with(const order::OrderResult& start, order::OrderOptions& options);
  [[nodiscard]] GroupResult result_of(const order::OrderResult& result) const;

  const std::vector<UnbegunCut>& cuts_;
  const std::vector<std::size_t>& members_;
  const RapidCost& cost_;
  const GroupTask& task_;
  order::OrderProblem problem_;
  std::vector<double> own_;  ///< Own cost of each candidate.
  std::vector<const Beginning*> beginning_;
  bool has_leads_ = false;  ///< Whether any closed cut ends at another point than its start.
};

void GroupProblem::add_home() {
  problem_.name = "cut";
  problem_.first_candidate = {0, 1};
  problem_.entry.push_back(plain(task_.to.value_or(task_.from)));
  problem_.exit.push_back(plain(task_.from));
  problem_.reversed.push_back(0);
  problem_.is_home_closed = task_.to && *task_.to == task_.from;
  problem_.is_symmetric = false;
  own_.push_back(0.0);
  beginning_.push_back(nullptr);
}

void GroupProblem::add_cut(const UnbegunCut& cut) {
  const std::size_t count = task_.only_usual ? 1 : cut.beginnings.size();
  const auto first = static_cast<Index>(problem_.entry.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Beginning& beginning = cut.beginnings[i];
    // The two candidates of an open line are its directions.
    const bool is_line = count == 2 && cut.beginnings[1].is_backwards;
    problem_.entry.push_back(plain(beginning.entry));
    problem_.exit.push_back(plain(beginning.exit));
    problem_.reversed.push_back(static_cast<Index>(is_line ? first + 1 - i : first + i));
    has_leads_ = has_leads_ || (!is_line && beginning.entry != beginning.exit);
    // A search may reverse stretches of the order. This must not change the own costs of lines in
    // the stretch.
    own_.push_back(is_line ? 0.5 * (cut.own_cost_of(0) + cut.own_cost_of(1)) : cut.own_cost_of(i));
    beginning_.push_back(&beginning);
  }
  problem_.first_candidate.push_back(static_cast<Index>(problem_.entry.size()));
}

void GroupProblem::add_pairs() {
  constexpr Index kNoSet = std::numeric_limits<Index>::max();
  std::vector<Index> set_of(cuts_.size(), kNoSet);
  for (std::size_t i = 0; i < members_.size(); ++i) set_of[members_[i]] = static_cast<Index>(i + 1);
  for (const std::size_t member : members_) {
    for (const std::size_t before : cuts_[member].after) {
      if (set_of[before] != kNoSet) problem_.pairs.push_back({set_of[before], set_of[member]});
    }
  }
}

/// Returns a problem in which each closed cut begins and ends in the middle between its two ends.
/// The rapids are then the same in both directions, so a search may reverse stretches.
order::OrderProblem GroupProblem::made_symmetric() const {
  order::OrderProblem problem = problem_;
  problem.is_symmetric = true;
  for (std::size_t i = 1; i < problem.entry.size(); ++i) {
    if (problem.reversed[i] != i) continue;
    problem.entry[i] = {0.5 * (problem.entry[i].x + problem.exit[i].x),
                        0.5 * (problem.entry[i].y + problem.exit[i].y)};
    problem.exit[i] = problem.entry[i];
  }
  return problem;
}

order::OrderResult GroupProblem::run(const order::OrderProblem& problem,
                                     bool is_symmetric,
                                     const order::OrderOptions& options,
                                     const order::OrderProgress& progress) const {
  const order::OwnedSpace<cnc::order::PrecedenceSpace> space{
      cnc::order::PrecedenceSizes{problem.sets(), problem.pairs.size()}};
  const auto precedence = cnc::order::sort_precedence(problem.sets(), problem.pairs, *space);
  CNC_ASSERT(precedence.ok());
  const cnc::order::Problem sorted{problem.first_candidate,
                                   problem.reversed,
                                   precedence.value(),
                                   is_symmetric,
                                   problem.is_home_closed};
  // Greatest number of candidates for which the table of leg costs fits into the cache.
  constexpr std::size_t kMaxKept = 1024;
  LegCost cost{{{problem.entry, problem.exit}, own_, !task_.to}, cost_};
  std::vector<double> table;
  if (options.method == order::OrderMethod::kOurs && problem.entry.size() <= kMaxKept) {
    cost.keep_in(table);
  }
  return order::OrderRun<LegCost>{problem, sorted, cost, options, progress}.solve();
}

void GroupProblem::begin_with(const std::vector<OrderedCut>& start,
                              order::OrderOptions& options) const {
  if (start.empty()) return;
  std::vector<Index> set_of(cuts_.size());
  for (std::size_t i = 0; i < members_.size(); ++i) set_of[members_[i]] = static_cast<Index>(i + 1);
  options.start_order = {0};
  options.start_chosen.assign(problem_.sets(), 0);
  for (const OrderedCut& ordered : start) {
    const Index set = set_of[ordered.cut];
    options.start_order.push_back(set);
    Index chosen = problem_.first_candidate[set];
    const Index end = problem_.first_candidate[set + 1];
    while (chosen + 1 < end &&
           (beginning_[chosen]->way_mm != ordered.beginning.way_mm ||
            beginning_[chosen]->is_backwards != ordered.beginning.is_backwards)) {
      ++chosen;
    }
    options.start_chosen[set] = chosen;
  }
}

void GroupProblem::begin_with(const order::OrderResult& start, order::OrderOptions& options) {
  options.start_order = start.order;
  options.start_chosen.assign(start.order.size(), 0);
  for (std::size_t i = 0; i < start.order.size(); ++i) {
    options.start_chosen[start.order[i]] = start.candidates[i];
  }
}

GroupResult GroupProblem::result_of(const order::OrderResult& result) const {
  GroupResult ordered{.cuts = {}, .is_proven = result.is_proven};
  for (std::size_t i = 1; i < result.order.size(); ++i) {
    ordered.cuts.push_back({members_[result.order[i] - 1], *beginning_[result.candidates[i]]});
  }
  return ordered;
}

GroupResult GroupProblem::solve(const order::OrderProgress& progress) {
  // Greatest number of cuts for which a proof of the best order takes little time.
  constexpr std::size_t kMaxProven = 13;
  constexpr double kTurningShare = 0.6;  // Share of the search that solves the symmetric problem.
  order::OrderOptions options;
  options.method = task_.method;
  options.seconds = task_.seconds;
  options.seed = task_.seed;
  options.may_prove = !task_.steps && members_.size() <= kMaxProven;
  begin_with(task_.start, options);
  if (task_.method != order::OrderMethod::kOurs) {
    return result_of(run(problem_, !has_leads_, options, progress));
  }
  const std::uint64_t steps =
      task_.steps.value_or(usual_steps(members_.size(), problem_.candidates()));
  if (!task_.seconds) options.steps = steps;
  if (has_leads_ && members_.size() > 2) {
    order::OrderOptions turning = options;
    turning.may_prove = false;
    if (task_.seconds) turning.seconds = kTurningShare * *task_.seconds;
    if (!task_.seconds)
      turning.steps = static_cast<std::uint64_t>(kTurningShare * static_cast<double>(steps));
    const order::OrderResult turned = run(made_symmetric(), true, turning, progress);
    begin_with(turned, options);
    if (task_.seconds) options.seconds = (1.0 - kTurningShare) * *task_.seconds;
    if (!task_.seconds) options.steps = steps - *turning.steps;
  }
  return result_of(run(problem_, !has_leads_, options, progress));
}

}  // namespace

std::uint64_t usual_steps(std::size_t cuts, std::size_t candidates) {
  // Number of legs that one step compares. In a small group, all cuts choose their candidates again
  // in each step. In a larger group, only the nearby cuts choose again.
  const double of_a_cut = static_cast<double>(candidates) / static_cast<double>(cuts);
  constexpr double kFewCuts = 64.0;  // Same value as in cnc::order::Search.
  const double count = static_cast<double>(cuts);
  const double chosen = count <= kFewCuts ? count : 24.0;
  const double legs_of_step = 3000.0 + 2.0 * chosen * of_a_cut * of_a_cut;
  constexpr double kLegs = 8.0e6;  // Number of compared legs for a small group.
  constexpr double kLegsOfCut = 0.12e6;
  constexpr double kMaxLegs = 1.2e9;
  const double legs = std::clamp(kLegsOfCut * count, kLegs, kMaxLegs);
  // The number of steps is large enough to try each cut at least once.
  return static_cast<std::uint64_t>(std::max(legs / legs_of_step, 2.0 * count));
}

GroupResult order_group(const std::vector<UnbegunCut>& cuts,
                        const std::vector<std::size_t>& members,
                        const RapidCost& cost,
                        const GroupTask& task,
                        const order::OrderProgress& progress) {
  if (members.empty()) return {};
  return GroupProblem{cuts, members, cost, task}.solve(progress);
}

}  // namespace sim::cut
