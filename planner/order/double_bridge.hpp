#pragma once

#include <algorithm>
#include <array>

#include "planner/order/feasibility.hpp"
#include "planner/order/legs.hpp"
#include "planner/order/random.hpp"

namespace cnc::order {

/// A change of three neighbouring stretches B C D of a tour to D C B. No exchange of three legs can
/// undo this disturbance.
struct DoubleBridge {
  /// Greatest number of sets in a stretch. A smaller limit would disturb the tour too little, and a
  /// greater limit would require more repair.
  static constexpr Index kLongest = 50;
  static constexpr Index kFewestSets = 4;

  Index start = 0;
  Index first = 0;  ///< Number of sets in the first stretch; likewise `second` and `third`.
  Index second = 0;
  Index third = 0;

  [[nodiscard]] bool keeps(const Feasibility& may) const {
    const Index middle = start + first;
    const Index last = middle + second;
    return may.may_swap(start, last, last + third) && may.may_swap(start, middle, last);
  }
};

/// Finds a random double bridge that keeps the precedence.
/// @return false if none of the kTries attempts keeps it
inline bool find_double_bridge(Random& random,
                               const Tour& tour,
                               const Feasibility& may,
                               DoubleBridge& bridge) {
  constexpr int kTries = 10;
  const Index sets = tour.size();
  if (sets < DoubleBridge::kFewestSets) return false;
  const Index longest = std::min(DoubleBridge::kLongest, (sets - 1) / 3);
  for (int i = 0; i < kTries; ++i) {
    bridge.first = 1 + random.below(longest);
    bridge.second = 1 + random.below(longest);
    bridge.third = 1 + random.below(longest);
    bridge.start = 1 + random.below(sets - bridge.first - bridge.second - bridge.third);
    if (bridge.keeps(may)) return true;
  }
  return false;
}

/// Makes a double bridge. Calls `touched(set)` for the sets at both ends of each leg that changes.
/// @return the gain: the decrease of the cost, usually below 0
template <LegCost Cost, typename Touched>
double make_double_bridge(const DoubleBridge& bridge,
                          Tour& tour,
                          const Legs<Cost>& legs,
                          Touched&& touched) {
  const auto sum_of_legs = [&](Index first, Index second) {
    const Index before = bridge.start - 1;
    const std::array<Index, 4> positions{before,
                                         before + first,
                                         before + first + second,
                                         before + bridge.first + bridge.second + bridge.third};
    double sum = 0.0;
    for (const Index position : positions) {
      sum += legs.after(position);
      touched(tour.at(position));
      touched(tour.at(tour.position_after(position)));
    }
    return sum;
  };
  const double removed = sum_of_legs(bridge.first, bridge.second);
  tour.swap(bridge.start, bridge.first + bridge.second, bridge.third);
  tour.swap(bridge.start + bridge.third, bridge.first, bridge.second);
  return removed - sum_of_legs(bridge.third, bridge.second);
}

}  // namespace cnc::order
