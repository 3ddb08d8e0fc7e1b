#pragma once

#include <algorithm>

#include "planner/order/legs.hpp"
#include "planner/order/random.hpp"

namespace cnc::order {

struct TurnedStretchSizes {
  std::size_t sets;
};

/// Storage of a TurnedStretch.
struct TurnedStretchSpace {
  std::span<Index> turned;
  std::span<Index> waits_for;

  template <typename Layout>
  void lay_out(Layout& layout, const TurnedStretchSizes& sizes) {
    layout(turned, sizes.sets);
    layout(waits_for, sizes.sets);
  }
};

/// A disturbance for tours with precedence. It reverses a stretch, except that a set with
/// predecessors in the stretch comes directly after the last of them. So a row of nested contours
/// is driven from its other end, still with inner contours first. No sequence of small changes
/// leads to such a tour without worse tours in between.
class TurnedStretch {
 public:
  /// Greatest number of sets in a stretch.
  static constexpr Index kLongest = 100;

  TurnedStretch(const Problem& problem, Tour& tour, const TurnedStretchSpace& space)
      : problem_{&problem}, tour_{&tour}, space_{space} {
    std::fill(space_.waits_for.begin(), space_.waits_for.end(), 0);
  }

  /// Turns a random stretch. Calls `touched(set)` for its sets and for the two neighbours of the
  /// stretch.
  /// @pre at least three sets
  /// @return the gain: the decrease of the cost, usually below 0
  template <LegCost Cost, typename Touched>
  double make(Random& random, const Legs<Cost>& legs, Touched&& touched) {
    const Index sets = tour_->size();
    const Index length = 2 + random.below(std::min(kLongest, sets - 1) - 1);
    const Index start = 1 + random.below(sets - length);
    const auto sum_of_legs = [&] {
      double sum = 0.0;
      for (Index i = start - 1; i < start + length; ++i) sum += legs.after(i);
      return sum;
    };
    const double removed = sum_of_legs();
    find(start, length);
    put_in_place(start, length);
    for (Index i = start - 1; i < start + length; ++i) touched(tour_->at(i));
    touched(tour_->at(tour_->position_after(start + length - 1)));
    return removed - sum_of_legs();
  }

 private:
  /// Writes the new order of a stretch to `turned`.
  void find(Index start, Index length) {
    const auto is_inside = [&](Index set) { return tour_->position_of(set) - start < length; };
    for (Index i = 0; i < length; ++i) {
      for (const Index after : problem_->precedence.after(tour_->at(start + i))) {
        if (is_inside(after)) ++space_.waits_for[after];
      }
    }
    Index done = 0;
    Index turned = 0;
    for (Index i = length; i-- > 0;) {
      const Index set = tour_->at(start + i);
      if (space_.waits_for[set] == 0) space_.turned[turned++] = set;
      for (; done < turned; ++done) {
        for (const Index after : problem_->precedence.after(space_.turned[done])) {
          if (!is_inside(after)) continue;
          // A set that the loop has not reached yet is added when the loop reaches it.
          const bool is_passed = tour_->position_of(after) - start >= i;
          if (--space_.waits_for[after] == 0 && is_passed) space_.turned[turned++] = after;
        }
      }
    }
  }

  void put_in_place(Index start, Index length) {
    for (Index i = 0; i < length; ++i) {
      const Index set = space_.turned[i];
      const Index from = tour_->position_of(set);
      if (from > start + i) tour_->swap(start + i, from - start - i, 1);
      const Index candidate = problem_->reversal_of(tour_->chosen(set));
      if (candidate != tour_->chosen(set)) tour_->choose(set, candidate);
    }
  }

  const Problem* problem_;
  Tour* tour_;
  TurnedStretchSpace space_;
};

}  // namespace cnc::order
