#pragma once

#include <algorithm>
#include <span>

#include "planner/order/exact_space.hpp"

namespace cnc::order {

enum class ExactState : std::uint8_t {
  kRunning,
  kProven,     ///< No tour is cheaper than best_cost().
  kDoesNotFit  ///< The storage is full.
};

/// Finds the cheapest tour and proves that it is the cheapest. It uses dynamic programming over the
/// collections of visited sets that precedence allows, with a cost for each last candidate. A state
/// is omitted if its bound is not below the cost of a known tour.
template <LegCost Cost>
class Exact {
 public:
  /// @param known_cost cost of a tour that the caller has; infinity if it has none
  /// @pre at least two sets, and at most kMaxMaskedSets sets besides home
  Exact(const Problem& problem,
        const Cost& cost,
        std::span<const Index> set_of,
        const ExactSpace& space,
        double known_cost)
      : problem_{&problem},
        cost_{&cost},
        space_{space},
        precedence_{problem},
        bound_{problem, cost, set_of, precedence_, space.bound},
        sets_{problem.sets() - 1},
        all_{sets_ == kMaxMaskedSets ? ~SetMask{0} : (SetMask{1} << sets_) - 1},
        best_cost_{known_cost},
        home_{problem.first_candidate[0]} {
    begin();
  }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;
  ~Exact() = default;

  /// Continues for a number of steps. A step either raises the bound, or extends one collection of
  /// visited sets.
  ExactState run(std::uint64_t steps) {
    for (std::uint64_t i = 0; i < steps && state_ == ExactState::kRunning; ++i) step();
    return state_;
  }

  [[nodiscard]] ExactState state() const { return state_; }
  [[nodiscard]] double best_cost() const { return best_cost_; }
  /// Returns whether the search found a tour that is cheaper than the known tour.
  [[nodiscard]] bool has_tour() const { return has_tour_; }
  [[nodiscard]] std::span<const Index> order() const { return space_.order; }
  [[nodiscard]] std::span<const Index> chosen() const { return space_.chosen; }
  /// Returns a lower bound of the cost of all tours that begin at the present candidate of home.
  [[nodiscard]] double first_bound() const { return first_bound_; }
  [[nodiscard]] std::size_t states() const { return state_count_; }
  /// Returns the number of visited sets in the states that are extended at present.
  [[nodiscard]] Index layer() const { return layer_; }

 private:
  using State = ExactSpace::State;
  static constexpr double kInfinite = std::numeric_limits<double>::infinity();
  /// Share of the known cost by which a tour must be cheaper to count as cheaper. A smaller
  /// difference may be rounding.
  static constexpr double kRounding = 1.0e-9;
  // Up to this number of sets, more rounds of the bound take longer than the better bound saves.
  static constexpr Index kFewSets = 20;
  static constexpr int kRoundsOfFew = 15;
  static constexpr int kRounds = 60;

  /// Returns the cost that the bound of a state must be below. Otherwise the state leads to no
  /// cheaper tour.
  [[nodiscard]] double limit() const { return best_cost_ - kRounding * std::abs(best_cost_); }

  void begin();
  void raise_bound();
  void step();
  void finish_layer();
  void finish_home();
  void extend(std::span<const State> group);
  bool add_state(SetMask visited, Index last, std::span<const State> group);
  double arrive(Index candidate, std::span<const State> group) const;
  void trace(Index candidate);
  [[nodiscard]] std::span<const State> group_of(Index layer, SetMask visited) const;

  const Problem* problem_;
  const Cost* cost_;
  ExactSpace space_;
  MaskedPrecedence precedence_;
  CompletionBound<Cost> bound_;
  Index sets_;
  SetMask all_;
  double best_cost_;
  Index home_;  ///< Present candidate of home.
  double first_bound_ = 0.0;
  Index layer_ = 1;
  std::size_t next_ = 0;  ///< Index of the next state to extend.
  std::size_t state_count_ = 0;
  std::size_t value_count_ = 0;
  bool has_tour_ = false;
  bool is_bounding_ = true;
  ExactState state_ = ExactState::kRunning;
};

/// Starts the search for tours from the present candidate of home.
template <LegCost Cost>
void Exact<Cost>::begin() {
  const int rounds = sets_ <= kFewSets ? kRoundsOfFew : kRounds;
  // Without a known tour, the prices have no target cost, so one round is made.
  bound_.start(best_cost_ < kForbidden ? rounds : 1);
  is_bounding_ = true;
}

template <LegCost Cost>
void Exact<Cost>::raise_bound() {
  if (bound_.raise(home_, best_cost_ < kForbidden ? best_cost_ : 0.0)) return;
  first_bound_ = bound_.finish(home_);
  is_bounding_ = false;
  layer_ = 1;
  next_ = 0;
  state_count_ = 0;
  value_count_ = 0;
  space_.layers[1] = 0;
  for (Index set = 1; set <= sets_; ++set) {
    if (precedence_.before(set) != 0) continue;
    if (!add_state(bit_of(set), set, {})) state_ = ExactState::kDoesNotFit;
  }
  space_.layers[2] = state_count_;
}

template <LegCost Cost>
void Exact<Cost>::step() {
  if (is_bounding_) {
    raise_bound();
    return;
  }
  const std::size_t end = space_.layers[layer_ + 1];
  if (next_ == end) {
    finish_layer();
    return;
  }
  std::size_t last = next_;
  while (last < end && space_.states[last].visited == space_.states[next_].visited) ++last;
  const auto group = space_.states.subspan(next_, last - next_);
  next_ = last;
  if (layer_ < sets_) extend(group);
}

template <LegCost Cost>
void Exact<Cost>::finish_layer() {
  if (layer_ == sets_) {
    finish_home();
    return;
  }
  ++layer_;
  space_.layers[layer_ + 1] = state_count_;
  const auto layer = space_.states.subspan(next_, state_count_ - next_);
  std::sort(layer.begin(), layer.end(), [](const State& a, const State& b) {
    return a.visited < b.visited || (a.visited == b.visited && a.last < b.last);
  });
}

template <LegCost Cost>
void Exact<Cost>::finish_home() {
  Index best = kNone;
  double least = limit();
  for (std::size_t i = space_.layers[sets_]; i < space_.layers[sets_ + 1]; ++i) {
    const State& state = space_.states[i];
    const Index first = problem_->first_candidate[state.last];
    for (Index k = 0; k < problem_->candidates_of(state.last); ++k) {
      const double cost = space_.values[state.values + k] + (*cost_)(first + k, home_);
      if (cost >= least) continue;
      least = cost;
      best = first + k;
    }
  }
  if (best != kNone) {
    best_cost_ = least;
    has_tour_ = true;
    trace(best);
  }
  if (++home_ < problem_->first_candidate[1]) {
    begin();
  } else {
    state_ = ExactState::kProven;
  }
}

template <LegCost Cost>
void Exact<Cost>::extend(std::span<const State> group) {
  const SetMask visited = group.front().visited;
  for (SetMask rest = all_ & ~visited; rest != 0; rest &= rest - 1) {
    const Index set = static_cast<Index>(std::countr_zero(rest)) + 1;
    if ((precedence_.before(set) & ~visited) != 0) continue;
    if (!add_state(visited | bit_of(set), set, group)) {
      state_ = ExactState::kDoesNotFit;
      return;
    }
  }
}

/// Adds the state that visits `last` after one of the states of a group. Adds nothing if the bound
/// shows that the state leads to no cheaper tour.
/// @param group states with the same visited sets; empty for the first set after home
/// @return false if the storage is full
template <LegCost Cost>
bool Exact<Cost>::add_state(SetMask visited, Index last, std::span<const State> group) {
  const Index count = problem_->candidates_of(last);
  if (state_count_ == space_.states.size() || value_count_ + count > space_.values.size()) {
    return false;
  }
  const double price = bound_.price_of(all_ & ~visited);
  const double most = limit();
  bool is_of_use = false;
  for (Index k = 0; k < count; ++k) {
    const Index candidate = problem_->first_candidate[last] + k;
    double cost = group.empty() ? (*cost_)(home_, candidate) : arrive(candidate, group);
    if (cost + bound_.rest(visited, candidate, price) >= most) cost = kInfinite;
    space_.values[value_count_ + k] = cost;
    is_of_use = is_of_use || cost < kInfinite;
  }
  if (!is_of_use) return true;
  space_.states[state_count_++] = {visited, value_count_, last};
  value_count_ += count;
  return true;
}

template <LegCost Cost>
double Exact<Cost>::arrive(Index candidate, std::span<const State> group) const {
  double least = kInfinite;
  for (const State& state : group) {
    const Index first = problem_->first_candidate[state.last];
    const Index count = problem_->candidates_of(state.last);
    for (Index k = 0; k < count; ++k) {
      const double cost = space_.values[state.values + k] + (*cost_)(first + k, candidate);
      least = std::min(least, cost);
    }
  }
  return least;
}

template <LegCost Cost>
std::span<const ExactSpace::State> Exact<Cost>::group_of(Index layer, SetMask visited) const {
  const auto all =
      space_.states.subspan(space_.layers[layer], space_.layers[layer + 1] - space_.layers[layer]);
  const auto [first, end] = std::equal_range(
      all.begin(), all.end(), State{visited, 0, 0}, [](const State& a, const State& b) {
        return a.visited < b.visited;
      });
  return {first, end};
}

/// Writes the tour that ends at a candidate, from its end to its start. Finds each predecessor as
/// the same minimum as the forward search.
template <LegCost Cost>
void Exact<Cost>::trace(Index candidate) {
  SetMask visited = all_;
  space_.order[0] = 0;
  space_.chosen[0] = home_;
  for (Index layer = sets_; layer > 0; --layer) {
    Index set = 1;
    while (problem_->first_candidate[set + 1] <= candidate) ++set;
    space_.order[layer] = set;
    space_.chosen[set] = candidate;
    visited &= ~bit_of(set);
    if (layer == 1) return;
    double least = kInfinite;
    Index best = candidate;
    for (const State& state : group_of(layer - 1, visited)) {
      const Index first = problem_->first_candidate[state.last];
      for (Index k = 0; k < problem_->candidates_of(state.last); ++k) {
        const double cost = space_.values[state.values + k] + (*cost_)(first + k, candidate);
        if (cost >= least) continue;
        least = cost;
        best = first + k;
      }
    }
    candidate = best;
  }
}

}  // namespace cnc::order
