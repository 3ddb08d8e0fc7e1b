#pragma once

#include "planner/order/tour.hpp"

namespace cnc::order {

/// The entry or the exit of a set from which a leg of the tour was removed.
struct LooseEnd {
  Index set;
  bool is_entry;
};

/// Costs of the legs of a tour, and of legs that would join loose ends.
template <LegCost Cost>
class Legs {
 public:
  Legs(const Problem& problem, const Cost& cost, const Tour& tour)
      : problem_{&problem}, cost_{&cost}, tour_{&tour} {}

  [[nodiscard]] double between(Index from_candidate, Index to_candidate) const {
    return (*cost_)(from_candidate, to_candidate);
  }

  /// Returns the cost of the leg that leaves the set at `position`.
  [[nodiscard]] double after(Index position) const {
    return between(tour_->chosen(tour_->at(position)),
                   tour_->chosen(tour_->at(tour_->position_after(position))));
  }

  /// Returns the cost of the leg that joins two ends. If both ends are entries, or both are exits,
  /// one of the two sets is reversed. Home is never reversed.
  /// @pre the problem is symmetric, or one end is an entry and the other an exit
  [[nodiscard]] double join(const LooseEnd& a, const LooseEnd& b) const {
    const Index first = tour_->chosen(a.set);
    const Index second = tour_->chosen(b.set);
    if (a.is_entry != b.is_entry) {
      return a.is_entry ? between(second, first) : between(first, second);
    }
    if (a.is_entry == (a.set == 0)) {
      return a.is_entry ? between(reversed(second), first) : between(first, reversed(second));
    }
    return a.is_entry ? between(reversed(first), second) : between(second, reversed(first));
  }

  [[nodiscard]] double tour_cost() const {
    double sum = 0.0;
    for (Index i = 0; i < tour_->size(); ++i) sum += after(i);
    return sum;
  }

  /// Returns the other end of the leg that begins or ends at `end`.
  [[nodiscard]] LooseEnd across(const LooseEnd& end) const {
    return {end.is_entry ? tour_->before(end.set) : tour_->after(end.set), !end.is_entry};
  }

  /// Returns the position of the set from which the leg at `end` starts.
  [[nodiscard]] Index leg_of(const LooseEnd& end) const {
    const Index position = tour_->position_of(end.set);
    return end.is_entry ? tour_->position_before(position) : position;
  }

 private:
  [[nodiscard]] Index reversed(Index candidate) const { return problem_->reversal_of(candidate); }

  const Problem* problem_;
  const Cost* cost_;
  const Tour* tour_;
};

}  // namespace cnc::order
