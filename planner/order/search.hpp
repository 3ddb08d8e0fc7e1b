#pragma once

#include <algorithm>

#include "planner/order/double_bridge.hpp"
#include "planner/order/entry_choice.hpp"
#include "planner/order/local_search.hpp"
#include "planner/order/turned_stretch.hpp"

namespace cnc::order {

struct SearchSizes {
  std::size_t sets;
  std::size_t candidates;
};

/// Storage of a Search.
struct SearchSpace {
  TourSpace tour;
  WorkQueueSpace queue;
  EntryChoiceSpace choice;
  TurnedStretchSpace turned;
  std::span<Index> best_order;
  std::span<Index> best_chosen;

  /// Greatest number of changes in one trial; further changes are not made.
  static constexpr std::size_t kMaxChanges = 4096;

  template <typename Layout>
  void lay_out(Layout& layout, const SearchSizes& sizes) {
    tour.lay_out(layout, {sizes.sets, sizes.sets + kMaxChanges});
    queue.lay_out(layout, {sizes.sets});
    choice.lay_out(layout, {sizes.candidates});
    turned.lay_out(layout, {sizes.sets});
    layout(best_order, sizes.sets);
    layout(best_chosen, sizes.sets);
  }
};

/// A search for the cheapest tour that may be stopped at any time. It begins with a local search
/// from a start that keeps the precedence; then it makes trials. A trial disturbs the tour by a
/// double bridge, and improves it by local search and by the best choice of candidates. If the
/// resulting tour is not good enough, the trial is undone.
///
/// The search is deterministic: the state after a number of steps depends only on problem, start,
/// seed and `slack`, with the same bits on every machine.
template <LegCost Cost>
class Search {
 public:
  /// The tour from which a search starts. It must keep the precedence.
  struct Start {
    std::span<const Index> order;   ///< A permutation of the sets, home first.
    std::span<const Index> chosen;  ///< Candidate that is chosen for each set, indexed by set.
  };

  /// Starts a search. All arguments except `start` must outlive the search.
  Search(const Problem& problem,
         const Cost& cost,
         const Neighbours& neighbours,
         const SearchSpace& space,
         const Start& start,
         std::uint64_t seed)
      : problem_{&problem},
        space_{space},
        tour_{started(problem, space.tour, start)},
        queue_{space.queue},
        min_gain_{kRounding * allowed_cost(Legs<Cost>{problem, cost, tour_})},
        local_{problem, cost, neighbours, tour_, queue_, min_gain_},
        choice_{problem, cost, tour_, space.choice},
        may_{problem.precedence, tour_},
        turned_{problem, tour_, space.turned},
        random_{seed},
        cost_{local_.legs().tour_cost()} {
    for (const Index set : tour_.order()) queue_.add(set);
    keep_best();
  }
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;
  ~Search() = default;

  /// Continues for a number of steps. In the first descent a step tries one set; afterwards a step
  /// is a trial.
  /// @param slack share of the run that is left, from 1 to 0. The greater it is, the worse an
  ///     accepted tour may be. With 0, no worse tour is accepted.
  void run(std::uint64_t steps, double slack) {
    for (std::uint64_t i = 0; i < steps; ++i) {
      if (is_descending_) {
        descend();
      } else {
        try_change(slack);
      }
    }
  }

  /// Returns whether the local search has tried all sets, so that further steps are trials.
  [[nodiscard]] bool is_locally_best() const { return !is_descending_; }
  [[nodiscard]] double best_cost() const { return std::min(best_cost_, cost_); }
  /// Returns the best order so far, home first. The span refers to the search's storage; a later
  /// run changes its content.
  [[nodiscard]] std::span<const Index> best_order() {
    if (cost_ < best_cost_) keep_best();
    return space_.best_order;
  }
  /// Returns the candidates of the best order, indexed by set.
  [[nodiscard]] std::span<const Index> best_chosen() {
    if (cost_ < best_cost_) keep_best();
    return space_.best_chosen;
  }

 private:
  /// Least gain that counts, as a share of the tour's cost. A smaller gain may be rounding.
  static constexpr double kRounding = 1.0e-12;
  /// Greatest loss that is accepted at `slack` 1, as a multiple of the mean cost of a leg; tuned on
  /// random points.
  static constexpr double kWarmth = 1.0;
  /// Greatest number of changes that one improvement makes.
  static constexpr std::size_t kChangesOfStep = 8;
  /// The best tour is copied only after one trial for each kSetsToKeep sets since the previous
  /// copy.
  static constexpr Index kSetsToKeep = 64;
  /// Number of trials after which the cost is recomputed, to remove accumulated rounding errors.
  static constexpr std::uint64_t kRecount = 1U << 16U;
  /// Number of sets before and after a tried set whose candidates are chosen again together with
  /// its own.
  static constexpr Index kReach = 2;
  /// Greatest number of sets for which all candidates are chosen again.
  static constexpr Index kFewSets = 64;
  // A constant N stands for the probability 1/N. kAgainOneIn is the constant for a further
  // disturbance. The other two are for a disturbance that reverses a stretch of the tour instead of
  // making a double bridge, with few sets and with many sets.
  static constexpr Index kAgainOneIn = 4;
  static constexpr Index kTurnOneInOfFew = 4;
  static constexpr Index kTurnOneIn = 8;

  static Tour started(const Problem& problem, const TourSpace& space, const Start& start) {
    Tour tour{problem, space};
    tour.assign(start.order, start.chosen);
    return tour;
  }

  double allowed_cost(const Legs<Cost>& legs) const {
    double sum = 0.0;
    for (Index i = 0; i < tour_.size(); ++i) {
      if (is_allowed(legs.after(i))) sum += legs.after(i);
    }
    return sum;
  }

  void descend() {
    tour_.forget_changes();
    if (!queue_.empty()) {
      cost_ -= local_.improve(queue_.take());
    } else {
      const double gain = choose_all();
      cost_ -= gain;
      is_descending_ = gain > 0.0;
    }
  }

  void try_change(double slack) {
    if (tour_.size() < 3) return;
    tour_.forget_changes();
    const double gain = disturb() + settle();
    const double may_lose = slack * kWarmth * random_.unit() * best_cost_ / tour_.size();
    if (gain >= -may_lose) {
      accept(gain);
    } else {
      tour_.take_back_changes();
    }
    if (++trials_ % kRecount == 0) cost_ = local_.legs().tour_cost();
  }

  /// Disturbs the tour. With few sets it sometimes disturbs more than once, because one double
  /// bridge reaches few orders.
  /// @return the gain: the decrease of the cost, usually below 0
  double disturb() {
    if (tour_.size() > kFewSets) return disturb_once(!problem_->precedence.empty(), kTurnOneIn);
    double gain = disturb_once(true, kTurnOneInOfFew);
    while (random_.below(kAgainOneIn) == 0) gain += disturb_once(true, kTurnOneInOfFew);
    // The disturbance keeps candidates that suit the previous order. Without a new choice, local
    // search would reject a good order because of them.
    if (random_.below(2) == 0) gain += choose_all();
    return gain;
  }

  double disturb_once(bool may_turn, Index turn_one_in) {
    const auto touched = [this](Index set) { queue_.add(set); };
    const bool has_bridge = tour_.size() >= DoubleBridge::kFewestSets;
    if (may_turn && (!has_bridge || random_.below(turn_one_in) == 0)) {
      return turned_.make(random_, local_.legs(), touched);
    }
    DoubleBridge bridge;
    if (!has_bridge || !find_double_bridge(random_, tour_, may_, bridge)) return 0.0;
    return make_double_bridge(bridge, tour_, local_.legs(), touched);
  }

  void accept(double gain) {
    cost_ -= gain;
    const bool is_due = trials_ >= kept_at_ + tour_.size() / kSetsToKeep;
    if (cost_ < best_cost_ && is_due) keep_best();
  }

  /// Improves the tour around the sets that have changed. @return the gain
  double settle() {
    double gain = 0.0;
    for (;;) {
      tried_count_ = 0;
      while (!queue_.empty()) {
        const Index set = queue_.take();
        if (!tour_.can_note(kChangesOfStep)) continue;
        gain += local_.improve(set);
        if (tried_count_ < tried_.size()) tried_[tried_count_++] = set;
      }
      if (problem_->candidates() == problem_->sets() || !tour_.can_note(tour_.size())) return gain;
      const double more = tour_.size() <= kFewSets ? choose_all() : choose_around();
      if (more <= 0.0) return gain;
      gain += more;
    }
  }

  /// Chooses candidates again, around the sets that local search tried. Returns the gain.
  double choose_around() {
    double gain = 0.0;
    for (std::size_t i = 0; i < tried_count_; ++i) {
      const Index position = tour_.position_of(tried_[i]);
      // The stretch around the previous set includes this set.
      if (i > 0 && position + 1 - tour_.position_of(tried_[i - 1]) <= 2) continue;
      const Index start = position >= kReach ? position - kReach : position + tour_.size() - kReach;
      gain += choice_.improve(start, 2 * kReach + 1, min_gain_, changed());
    }
    return gain;
  }

  double choose_all() { return choice_.improve_all(min_gain_, changed()); }

  auto changed() {
    return [this](Index set) {
      queue_.add(set);
      queue_.add(tour_.before(set));
      queue_.add(tour_.after(set));
    };
  }

  void keep_best() {
    std::copy(tour_.order().begin(), tour_.order().end(), space_.best_order.begin());
    std::copy(tour_.choices().begin(), tour_.choices().end(), space_.best_chosen.begin());
    const auto home = std::find(space_.best_order.begin(), space_.best_order.end(), Index{0});
    std::rotate(space_.best_order.begin(), home, space_.best_order.end());
    best_cost_ = cost_;
    kept_at_ = trials_;
  }

  const Problem* problem_;
  SearchSpace space_;
  Tour tour_;
  WorkQueue queue_;
  double min_gain_;
  LocalSearch<Cost> local_;
  EntryChoice<Cost> choice_;
  Feasibility may_;
  TurnedStretch turned_;
  Random random_;
  double cost_;
  double best_cost_ = 0.0;
  std::array<Index, 100> tried_{};
  std::size_t tried_count_ = 0;
  std::uint64_t trials_ = 0;
  std::uint64_t kept_at_ = 0;
  bool is_descending_ = true;
};

}  // namespace cnc::order
