#pragma once

#include "planner/order/tour.hpp"

namespace cnc::order {

/// Checks whether a change of a tour keeps the precedence. Stretches are ranges of positions
/// [begin, end) that contain neither home nor the end of the order.
class Feasibility {
 public:
  Feasibility(const Precedence& precedence, const Tour& tour)
      : precedence_{&precedence}, tour_{&tour} {}

  /// Returns whether the stretch may be reversed: no set in it must come after another set in it.
  [[nodiscard]] bool may_reverse(Index begin, Index end) const {
    for (Index i = begin; i < end; ++i) {
      if (has_any_in(precedence_->after(tour_->at(i)), i, end)) return false;
    }
    return true;
  }

  /// Returns whether [middle, end) may come before [begin, middle). A check of direct pairs
  /// suffices, because a chain between two sets has at least one pair that leads from the first
  /// stretch into the second.
  [[nodiscard]] bool may_swap(Index begin, Index middle, Index end) const {
    if (middle - begin <= end - middle) {
      for (Index i = begin; i < middle; ++i) {
        if (has_any_in(precedence_->after(tour_->at(i)), middle, end)) return false;
      }
      return true;
    }
    for (Index i = middle; i < end; ++i) {
      if (has_any_in(precedence_->before(tour_->at(i)), begin, middle)) return false;
    }
    return true;
  }

  [[nodiscard]] bool may_rearrange(Rearrangement how, Index begin, Index middle, Index end) const {
    switch (how) {
      case Rearrangement::kSwap:
        return may_swap(begin, middle, end);
      case Rearrangement::kSwapReverseFirst:
        return may_swap(begin, middle, end) && may_reverse(begin, middle);
      case Rearrangement::kSwapReverseSecond:
        return may_swap(begin, middle, end) && may_reverse(middle, end);
      case Rearrangement::kReverseBoth:
        return may_reverse(begin, middle) && may_reverse(middle, end);
    }
    return false;
  }

 private:
  [[nodiscard]] bool has_any_in(std::span<const Index> sets, Index begin, Index end) const {
    for (const Index set : sets) {
      const Index position = tour_->position_of(set);
      if (position >= begin && position < end) return true;
    }
    return false;
  }

  const Precedence* precedence_;
  const Tour* tour_;
};

}  // namespace cnc::order
