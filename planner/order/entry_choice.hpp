#pragma once

#include <algorithm>
#include <span>

#include "planner/order/legs.hpp"

namespace cnc::order {

struct EntryChoiceSizes {
  std::size_t candidates;
};

/// Storage of an EntryChoice.
struct EntryChoiceSpace {
  std::span<double> cost;
  std::span<Index> before;
  /// Best candidates, one for each set. The size suffices because there are at least as many
  /// candidates as sets.
  std::span<Index> best;

  template <typename Layout>
  void lay_out(Layout& layout, const EntryChoiceSizes& sizes) {
    layout(cost, sizes.candidates);
    layout(before, sizes.candidates);
    layout(best, sizes.candidates);
  }
};

/// Finds the best candidates along a tour whose order is fixed. The method is an exact shortest
/// path through layers of candidates.
template <LegCost Cost>
class EntryChoice {
 public:
  EntryChoice(const Problem& problem, const Cost& cost, Tour& tour, const EntryChoiceSpace& space)
      : problem_{&problem}, cost_{&cost}, tour_{&tour}, space_{space}, legs_{problem, cost, tour} {}

  /// Chooses the best candidates for `length` sets from the position `start` on. The choices of the
  /// sets before and after them stay fixed. Calls `changed(set)` for each set whose candidate
  /// changes.
  /// @return the decrease of the tour's cost; a change that gains at most `min_gain` is not made
  template <typename Changed>
  double improve(Index start, Index length, double min_gain, Changed&& changed) {
    const Index before = tour_->at(tour_->position_before(start));
    const Index behind = tour_->at(position(start, length));
    double present = 0.0;
    for (Index i = 0; i <= length; ++i) {
      present += legs_.after(tour_->position_before(position(start, i)));
    }
    const double cost = find(start, length, tour_->chosen(before), tour_->chosen(behind));
    if (present - cost <= min_gain) return 0.0;
    take(start, length, changed);
    return present - cost;
  }

  /// Chooses the best candidates for all sets, including home. In all other respects it works like
  /// improve().
  template <typename Changed>
  double improve_all(double min_gain, Changed&& changed) {
    const Index home = tour_->at(0);
    const Index length = tour_->size() - 1;
    const double present = legs_.tour_cost();
    double least = present - min_gain;
    Index best = kNone;
    Index last = kNone;
    for (Index c = problem_->first_candidate[home]; c < problem_->first_candidate[home + 1]; ++c) {
      const double cost = find(1, length, c, c);
      last = c;
      if (cost >= least) continue;
      least = cost;
      best = c;
    }
    if (best == kNone) return 0.0;
    if (best != last) static_cast<void>(find(1, length, best, best));
    set_choice(home, best, changed);
    take(1, length, changed);
    return present - least;
  }

 private:
  [[nodiscard]] Index position(Index start, Index step) const {
    return start + step >= tour_->size() ? start + step - tour_->size() : start + step;
  }

  /// Returns the least cost from the candidate `from` through the layers to the candidate `to`.
  /// Writes the choices to `best`, in the order of the steps.
  double find(Index start, Index length, Index from, Index to) {
    Index last_first = kNone;
    Index last_end = kNone;
    for (Index i = 0; i < length; ++i) {
      const Index set = tour_->at(position(start, i));
      const Index first = problem_->first_candidate[set];
      const Index end = problem_->first_candidate[set + 1];
      for (Index c = first; c < end; ++c) {
        if (i == 0) {
          space_.cost[c] = (*cost_)(from, c);
          space_.before[c] = kNone;
        } else {
          reach(c, last_first, last_end);
        }
      }
      last_first = first;
      last_end = end;
    }
    return trace(start, length, to);
  }

  void reach(Index candidate, Index first, Index end) {
    double least = std::numeric_limits<double>::infinity();
    Index by = first;
    for (Index b = first; b < end; ++b) {
      const double cost = space_.cost[b] + (*cost_)(b, candidate);
      if (cost < least) {
        least = cost;
        by = b;
      }
    }
    space_.cost[candidate] = least;
    space_.before[candidate] = by;
  }

  double trace(Index start, Index length, Index to) {
    const Index set = tour_->at(position(start, length - 1));
    double least = std::numeric_limits<double>::infinity();
    Index candidate = kNone;
    for (Index c = problem_->first_candidate[set]; c < problem_->first_candidate[set + 1]; ++c) {
      const double cost = space_.cost[c] + (*cost_)(c, to);
      if (cost >= least) continue;
      least = cost;
      candidate = c;
    }
    for (Index i = length; i-- > 0;) {
      space_.best[i] = candidate;
      // The first set of the stretch has no candidate before it: the value is kNone.
      candidate = space_.before[candidate];
    }
    return least;
  }

  template <typename Changed>
  void take(Index start, Index length, Changed&& changed) {
    for (Index i = 0; i < length; ++i) {
      set_choice(tour_->at(position(start, i)), space_.best[i], changed);
    }
  }

  template <typename Changed>
  void set_choice(Index set, Index candidate, Changed&& changed) {
    if (tour_->chosen(set) == candidate) return;
    tour_->choose(set, candidate);
    changed(set);
  }

  const Problem* problem_;
  const Cost* cost_;
  Tour* tour_;
  EntryChoiceSpace space_;
  Legs<Cost> legs_;
};

}  // namespace cnc::order
