#pragma once

#include <cstdlib>
#include "planner/order/entry_choice.hpp"
#include "planner/order/local_search.hpp"
#include "planner/order/random.hpp"

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
  std::span<Index> best_order;
  std::span<Index> best_chosen;

  /// Changes that one trial may make before it is judged as it is.
  static constexpr std::size_t kMaxChanges = 4096;

  template <typename Layout>
  void lay_out(Layout& layout, const SearchSizes& sizes) {
    tour.lay_out(layout, {sizes.sets, kMaxChanges});
    queue.lay_out(layout, {sizes.sets});
    choice.lay_out(layout, {sizes.candidates});
    layout(best_order, sizes.sets);
    layout(best_chosen, sizes.sets);
  }
};

/// A search for the cheapest tour that may be stopped at any time: local search from a start that
/// keeps the precedence, then trials, each a random exchange of short neighbouring stretches, what
/// local search and the best choice of candidates make of it, and all of that taken back unless the
/// tour is good enough.
///
/// Deterministic: the state after a number of steps depends on problem, start and seed alone.
template <LegCost Cost>
class Search {
 public:
  /// The arguments must outlive the search, except `order` and `chosen`.
  /// @param order a permutation of the sets with home first that keeps the precedence
  /// @param chosen a candidate of each set
  Search(const Problem& problem,
         const Cost& cost,
         const Neighbours& neighbours,
         const SearchSpace& space,
         std::span<const Index> order,
         std::span<const Index> chosen,
         std::uint64_t seed)
      : problem_{&problem},
        space_{space},
        tour_{started(problem, space.tour, order, chosen)},
        queue_{space.queue},
        least_gain_{kRounding * allowed_cost(Legs<Cost>{problem, cost, tour_})},
        local_{problem, cost, neighbours, tour_, queue_, least_gain_},
        nb_{&neighbours},
        choice_{problem, cost, tour_, space.choice},
        random_{seed},
        cost_{local_.legs().tour_cost()} {
    for (const Index set : tour_.order()) queue_.add(set);
    keep_best();
  }
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;

  /// Goes on by a number of steps: sets tried in the first descent, trials after it.
  void run(std::uint64_t steps) {
    for (std::uint64_t i = 0; i < steps; ++i) step();
  }

  double progress_ = 0;
  [[nodiscard]] double best_cost() const { return best_cost_; }

  /// Returns the best order so far, home first, in the storage of the search. The search may go on.
  [[nodiscard]] std::span<const Index> best_order() {
    if (!is_best_kept_) keep_best();
    return space_.best_order;
  }
  /// Returns the candidates of that order, by set.
  /// @pre best_order() was called since the last step
  [[nodiscard]] std::span<const Index> best_chosen() const { return space_.best_chosen; }

 private:
  static constexpr double kRounding = 1.0e-12;  ///< Of all of the tour's cost.

  static Tour started(const Problem& problem,
                      const TourSpace& space,
                      std::span<const Index> order,
                      std::span<const Index> chosen) {
    Tour tour{problem, space};
    tour.assign(order, chosen);
    return tour;
  }

  double allowed_cost(const Legs<Cost>& legs) const {
    double sum = 0.0;
    for (Index i = 0; i < tour_.size(); ++i) {
      if (is_allowed(legs.after(i))) sum += legs.after(i);
    }
    return sum;
  }

  void step() {
    if (is_descending_) {
      descend();
    } else {
      try_change();
    }
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
    best_cost_ = cost_;
    is_best_kept_ = false;
  }

  double choose_all() {
    return choice_.improve_all(least_gain_, [this](Index set) { changed(set); });
  }

  void changed(Index set) {
    queue_.add(set);
    queue_.add(tour_.before(set));
    queue_.add(tour_.after(set));
  }

  void try_change() {
    tour_.forget_changes();
    Kick kick{};
    if (!find_kick(kick)) return;
    const double gain = make(kick) + settle();
    static const double TT = std::getenv("TT")?std::atof(std::getenv("TT")):0.0;
    const double least = -TT*(1-progress_)*random_.unit()*cost_/tour_.size();
    if (gain >= least) {
      cost_ -= gain;
      if (cost_ < best_cost_) {
        best_cost_ = cost_;
        is_best_kept_ = false;
      }
    } else {
      tour_.take_back_changes();
    }
  }

  /// Returns the gain of local search and of the best candidates around the change.
  double settle() {
    double gain = 0.0;
    for (;;) {
      while (!queue_.empty()) {
        const Index set = queue_.take();
        if (tour_.can_note(kMaxChangesOfStep)) gain += local_.improve(set);
      }
      if (problem_->candidates() == problem_->sets() || !tour_.can_note(tour_.size())) return gain;
      const double more = choose_all();
      if (more <= 0.0) return gain;
      gain += more;
    }
  }

  /// A random double bridge: three neighbouring stretches B C D become D C B, which no exchange of
  /// three legs takes back.
  struct Kick {
    Index start;
    Index first;
    Index second;
    Index third;
  };

  bool find_kick(Kick& kick) {
    static const Index kLongest = std::getenv("KL")?std::atoi(std::getenv("KL")):50;
    constexpr int kTries = 10;
    const Index sets = tour_.size();
    if (sets < 5) return false;
    const Index longest = std::min(kLongest, (sets - 1) / 3);
    static const int RW = std::getenv("RW")?std::atoi(std::getenv("RW")):0;
    static const Index RM = std::getenv("RM")?std::atoi(std::getenv("RM")):1000;
    if (RW > 0) for (int i = 0; i < kTries; ++i) {
      std::array<Index, 4> p{};
      Index v = random_.below(sets);
      p[0] = tour_.position_of(v);
      for (int j = 1; j < 4; ++j) {
        Index w = v;
        for (int k = 0; k < RW; ++k) { const Index t = nb_->of(w)[random_.below(5)]; if (t != kNone) w = t; }
        p[static_cast<std::size_t>(j)] = tour_.position_of(w);
      }
      std::sort(p.begin(), p.end());
      if (p[0] == p[1] || p[1] == p[2] || p[2] == p[3]) continue;
      if (p[3] - p[0] > RM) continue;
      kick.start = p[0] + 1; kick.first = p[1] - p[0]; kick.second = p[2] - p[1]; kick.third = p[3] - p[2];
      if (may_make(kick)) return true;
    }
    for (int i = 0; i < kTries; ++i) {
      kick.first = 1 + random_.below(longest);
      kick.second = 1 + random_.below(longest);
      kick.third = 1 + random_.below(longest);
      kick.start = 1 + random_.below(sets - kick.first - kick.second - kick.third);
      if (may_make(kick)) return true;
    }
    return false;
  }

  bool may_make(const Kick& kick) const {
    if (problem_->precedence.empty()) return true;
    const Feasibility may{problem_->precedence, tour_};
    const Index second = kick.start + kick.first;
    const Index third = second + kick.second;
    return may.may_swap(kick.start, third, third + kick.third) &&
           may.may_swap(kick.start, second, third);
  }

  /// @return the gain, below 0 as a rule
  double make(const Kick& kick) {
    const auto& legs = local_.legs();
    const Index second = kick.start + kick.first;
    const Index third = second + kick.second;
    const auto cuts = [&](Index a, Index b) {
      const std::array<Index, 4> positions{kick.start - 1, kick.start + a - 1,
                                           kick.start + a + b - 1, third + kick.third - 1};
      double sum = 0.0;
      for (const Index position : positions) {
        sum += legs.after(position);
        queue_.add(tour_.at(position));
        queue_.add(tour_.at(tour_.position_after(position)));
      }
      return sum;
    };
    const double removed = cuts(kick.first, kick.second);
    tour_.swap(kick.start, kick.first + kick.second, kick.third);
    tour_.swap(kick.start + kick.third, kick.first, kick.second);
    return removed - cuts(kick.third, kick.second);
  }

  void keep_best() {
    std::copy(tour_.order().begin(), tour_.order().end(), space_.best_order.begin());
    std::copy(tour_.choices().begin(), tour_.choices().end(), space_.best_chosen.begin());
    const auto home = std::find(space_.best_order.begin(), space_.best_order.end(), Index{0});
    std::rotate(space_.best_order.begin(), home, space_.best_order.end());
    is_best_kept_ = true;
    best_cost_ = cost_;
  }

  static constexpr std::size_t kMaxChangesOfStep = 16;

  const Problem* problem_;
  SearchSpace space_;
  Tour tour_;
  WorkQueue queue_;
  double least_gain_;
  LocalSearch<Cost> local_;
  const Neighbours* nb_;
  EntryChoice<Cost> choice_;
  Random random_;
  double cost_;
  double best_cost_ = 0.0;
  bool is_descending_ = true;
  bool is_best_kept_ = false;
};

}  // namespace cnc::order
