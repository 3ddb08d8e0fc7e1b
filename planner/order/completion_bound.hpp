#pragma once

#include <algorithm>
#include <span>

#include "planner/order/set_masks.hpp"

namespace cnc::order {

struct CompletionBoundSizes {
  std::size_t sets;
  std::size_t candidates;
};

/// The cheapest continuation of a walk from a candidate, and the cheapest continuation through a
/// different next set.
struct WalkRest {
  double cost;
  double other_cost;
  Index next;  ///< Next candidate of the walk.
  /// Next candidate of the cheapest continuation through a set other than `next_set`.
  Index other_next;
  Index next_set;
};
inline constexpr WalkRest kNoWalk{std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::infinity(),
                                  kNone,
                                  kNone,
                                  kNone};

/// Storage of a CompletionBound.
struct CompletionBoundSpace {
  std::span<WalkRest> rests;
  std::span<double> prices;
  std::span<double> best_prices;
  std::span<Index> visits;

  template <typename Layout>
  void lay_out(Layout& layout, const CompletionBoundSizes& sizes) {
    layout(rests, sizes.sets * sizes.candidates);
    layout(prices, sizes.sets);
    layout(best_prices, sizes.sets);
    layout(visits, sizes.sets);
  }
};

/// Computes a lower bound of the cost of the rest of a tour.
///
/// A walk has as many steps as a tour, but need not visit each set exactly once. The cheapest walk
/// is found backwards, step by step. Each set has a price. The bound contains the price once and
/// refunds it at each visit, so prices do not change the cost of a tour. With suitable prices the
/// cheapest walks are almost tours (Lagrange multipliers by subgradients, after Held and Karp
/// 1971). A walk does not return directly to the set that it has just left. It observes the rules
/// of precedence for neighbours and for positions in the tour.
template <LegCost Cost>
class CompletionBound {
 public:
  CompletionBound(const Problem& problem,
                  const Cost& cost,
                  std::span<const Index> set_of,
                  const MaskedPrecedence& precedence,
                  const CompletionBoundSpace& space)
      : problem_{&problem},
        cost_{&cost},
        set_of_{set_of},
        precedence_{&precedence},
        space_{space},
        sets_{problem.sets() - 1} {}

  /// Starts the search for prices. Good prices bring the bound of the complete tour near to the
  /// cost of a known tour.
  void start(int rounds) {
    std::fill(space_.prices.begin(), space_.prices.end(), 0.0);
    std::copy(space_.prices.begin(), space_.prices.end(), space_.best_prices.begin());
    best_ = -std::numeric_limits<double>::infinity();
    share_ = 1.0;
    since_best_ = 0;
    rounds_left_ = rounds;
  }

  /// Evaluates the present prices and changes them once.
  /// @param home candidate where the tour begins and ends
  /// @return false if all rounds are used, or if further calls would hardly raise the bound
  bool raise(Index home, double known_cost) {
    const double bound = find(home);
    if (bound > best_) {
      best_ = bound;
      since_best_ = 0;
      std::copy(space_.prices.begin(), space_.prices.end(), space_.best_prices.begin());
    } else if (++since_best_ > kPatience) {
      since_best_ = 0;
      share_ /= 2.0;
    }
    return --rounds_left_ > 0 && share_ > kMinShare && move_prices(share_, known_cost - bound);
  }

  /// Restores the best prices, for rest(). @return the bound of the complete tour
  double finish(Index home) {
    std::copy(space_.best_prices.begin(), space_.best_prices.end(), space_.prices.begin());
    return find(home);
  }

  /// Returns the sum of the prices of all sets in a mask.
  [[nodiscard]] double price_of(SetMask mask) const {
    double sum = 0.0;
    for (; mask != 0; mask &= mask - 1) {
      sum += space_.prices[static_cast<std::size_t>(std::countr_zero(mask)) + 1];
    }
    return sum;
  }

  /// Returns a lower bound of the rest of a tour that is at `candidate` and has visited the sets
  /// `visited`.
  /// @param price_to_come sum of the prices of the sets that are not visited yet
  [[nodiscard]] double rest(SetMask visited, Index candidate, double price_to_come) const {
    const WalkRest& rest = at(count_of(visited), candidate);
    if (rest.next_set == kNone) return rest.cost;
    const bool is_open = rest.next_set == 0 || (visited & bit_of(rest.next_set)) == 0;
    return (is_open ? rest.cost : rest.other_cost) + price_to_come;
  }

 private:
  static constexpr double kMinShare = 1.0e-3;
  static constexpr int kPatience = 4;

  [[nodiscard]] WalkRest& at(Index number, Index candidate) const {
    return space_.rests[std::size_t{number - 1} * set_of_.size() + candidate];
  }

  template <typename Visit>
  void for_each_candidate_at(Index number, Visit&& visit) const {
    for (Index set = 1; set <= sets_; ++set) {
      if (!precedence_->may_be_at(set, number)) continue;
      for (Index c = problem_->first_candidate[set]; c < problem_->first_candidate[set + 1]; ++c) {
        visit(set, c);
      }
    }
  }

  static void offer(WalkRest& rest, double cost, Index set, Index candidate) {
    if (cost < rest.cost) {
      if (rest.next_set != set) {
        rest.other_cost = rest.cost;
        rest.other_next = rest.next;
      }
      rest.cost = cost;
      rest.next = candidate;
      rest.next_set = set;
    } else if (cost < rest.other_cost && set != rest.next_set) {
      rest.other_cost = cost;
      rest.other_next = candidate;
    }
  }

  /// Finds the cheapest continuations of all walks for the present prices. Counts the visits of the
  /// cheapest walk to each set. Returns the bound of the tour.
  double find(Index home) {
    for_each_candidate_at(sets_, [&](Index, Index c) {
      at(sets_, c) = kNoWalk;
      at(sets_, c).cost = (*cost_)(c, home);
      at(sets_, c).next_set = 0;
    });
    for (Index number = sets_; --number > 0;) {
      for_each_candidate_at(number, [&](Index set, Index c) { find_rest(number, set, c); });
    }
    WalkRest start = kNoWalk;
    for_each_candidate_at(1, [&](Index set, Index c) {
      offer(start, (*cost_)(home, c) + at(1, c).cost - space_.prices[set], set, c);
    });
    count_visits(start.next);
    double bound = start.cost;
    for (Index set = 1; set <= sets_; ++set) bound += space_.prices[set];
    return bound;
  }

  void find_rest(Index number, Index set, Index candidate) {
    WalkRest& rest = at(number, candidate);
    rest = kNoWalk;
    for_each_set_after(number, set, [&](Index then) {
      const double price = space_.prices[then];
      for (Index c = problem_->first_candidate[then]; c < problem_->first_candidate[then + 1];
           ++c) {
        const WalkRest& further = at(number + 1, c);
        const double cost = further.next_set == set ? further.other_cost : further.cost;
        offer(rest, (*cost_)(candidate, c) + cost - price, then, c);
      }
    });
  }

  template <typename Visit>
  void for_each_set_after(Index number, Index set, Visit&& visit) const {
    for (Index then = 1; then <= sets_; ++then) {
      if (precedence_->may_be_at(then, number + 1) && precedence_->may_follow(set, then)) {
        visit(then);
      }
    }
  }

  void count_visits(Index candidate) {
    std::fill(space_.visits.begin(), space_.visits.end(), 0);
    Index before = kNone;
    for (Index number = 1; candidate != kNone && number <= sets_; ++number) {
      const Index set = set_of_[candidate];
      ++space_.visits[set];
      const WalkRest& rest = at(number, candidate);
      candidate = rest.next_set == before ? rest.other_next : rest.next;
      before = set;
    }
  }

  /// Changes the prices in proportion to the missing or surplus visits of each set.
  /// @return false if the cheapest walk is a tour
  bool move_prices(double share, double gap) {
    double squares = 0.0;
    for (Index set = 1; set <= sets_; ++set) {
      const double miss = 1.0 - static_cast<double>(space_.visits[set]);
      squares += miss * miss;
    }
    if (squares == 0.0) return false;
    for (Index set = 1; set <= sets_; ++set) {
      const double miss = 1.0 - static_cast<double>(space_.visits[set]);
      space_.prices[set] += share * std::max(gap, 0.0) / squares * miss;
    }
    return true;
  }

  const Problem* problem_;
  const Cost* cost_;
  std::span<const Index> set_of_;
  const MaskedPrecedence* precedence_;
  CompletionBoundSpace space_;
  Index sets_;
  double best_ = 0.0;
  double share_ = 1.0;
  int since_best_ = 0;
  int rounds_left_ = 0;
};

}  // namespace cnc::order
