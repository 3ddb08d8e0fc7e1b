#pragma once

#include <span>

#include "planner/order/neighbours.hpp"

namespace cnc::order {

struct NearestOrderSizes {
  std::size_t sets;
};

/// Storage of nearest_order().
struct NearestOrderSpace {
  std::span<Index> order;
  std::span<Index> chosen;
  std::span<Index> waits_for;

  template <typename Layout>
  void lay_out(Layout& layout, const NearestOrderSizes& sizes) {
    layout(order, sizes.sets);
    layout(chosen, sizes.sets);
    layout(waits_for, sizes.sets);
  }
};

/// Writes an order in which each step goes to the nearest candidate of all sets that may come next.
/// @param nearest object with three functions. `add(set)` is called for each set that becomes
///     permitted as the next set, `remove(set)` for each set that has been visited.
///     `next(candidate)` returns the candidate nearest to the exit of `candidate`
template <typename Nearest>
void nearest_order(const Problem& problem, Nearest&& nearest, const NearestOrderSpace& space) {
  const Index sets = problem.sets();
  for (Index set = 1; set < sets; ++set) {
    space.waits_for[set] = 0;
    for (const Index before : problem.precedence.before(set)) {
      if (before != 0) ++space.waits_for[set];
    }
    if (space.waits_for[set] == 0) nearest.add(set);
  }
  space.order[0] = 0;
  space.chosen[0] = problem.first_candidate[0];
  for (Index i = 1; i < sets; ++i) {
    const auto [set, candidate] = nearest.next(space.chosen[space.order[i - 1]]);
    space.order[i] = set;
    space.chosen[set] = candidate;
    nearest.remove(set);
    for (const Index after : problem.precedence.after(set)) {
      if (--space.waits_for[after] == 0) nearest.add(after);
    }
  }
}

struct SetAndCandidate {
  Index set;
  Index candidate;
};

/// Finds the nearest candidate by distance in the plane, in O(log n) per search.
class NearestPlace {
 public:
  /// @param tree tree of all entries, of which none is present yet
  NearestPlace(const Problem& problem,
               const CandidatePlaces& places,
               std::span<const Index> set_of,
               PlaceTree& tree)
      : problem_{&problem}, places_{places}, set_of_{set_of}, tree_{&tree} {}

  void add(Index set) {
    for (Index c = problem_->first_candidate[set]; c < problem_->first_candidate[set + 1]; ++c) {
      tree_->insert(c);
    }
  }
  void remove(Index set) {
    for (Index c = problem_->first_candidate[set]; c < problem_->first_candidate[set + 1]; ++c) {
      tree_->remove(c);
    }
  }
  [[nodiscard]] SetAndCandidate next(Index from) const {
    double least = std::numeric_limits<double>::infinity();
    Index best = kNone;
    tree_->search(places_.exit[from], least, [&](Index candidate, double distance) {
      if (distance < least || (distance == least && candidate < best)) {
        least = distance;
        best = candidate;
      }
      return least;
    });
    return {set_of_[best], best};
  }

 private:
  const Problem* problem_;
  CandidatePlaces places_;
  std::span<const Index> set_of_;
  PlaceTree* tree_;
};

/// Finds the nearest candidate by the cost of legs. It compares all candidates, so it is meant for
/// explicit matrices.
template <LegCost Cost>
class NearestByCost {
 public:
  /// @param is_open flag for each candidate; all flags are 0
  NearestByCost(const Problem& problem,
                const Cost& cost,
                std::span<const Index> set_of,
                std::span<std::uint8_t> is_open)
      : problem_{&problem}, cost_{&cost}, set_of_{set_of}, is_open_{is_open} {}

  void add(Index set) { mark(set, 1); }
  void remove(Index set) { mark(set, 0); }
  [[nodiscard]] SetAndCandidate next(Index from) const {
    double least = std::numeric_limits<double>::infinity();
    Index best = kNone;
    for (Index c = 0; c < is_open_.size(); ++c) {
      if (is_open_[c] == 0 || (*cost_)(from, c) >= least) continue;
      least = (*cost_)(from, c);
      best = c;
    }
    return {set_of_[best], best};
  }

 private:
  void mark(Index set, std::uint8_t is_open) {
    for (Index c = problem_->first_candidate[set]; c < problem_->first_candidate[set + 1]; ++c) {
      is_open_[c] = is_open;
    }
  }

  const Problem* problem_;
  const Cost* cost_;
  std::span<const Index> set_of_;
  std::span<std::uint8_t> is_open_;
};

}  // namespace cnc::order
