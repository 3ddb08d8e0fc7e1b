#pragma once

#include <array>
#include <utility>

#include "planner/order/legs.hpp"

namespace cnc::order {

/// Exchange of two or three legs of a tour for new legs. The tour is cut after the positions
/// `cuts`, which ascend, and its stretches are joined differently.
struct Exchange {
  std::array<Index, 3> cuts{};
  bool has_three = false;
  /// Rearrangement for three legs. With two legs, a stretch is reversed instead.
  Rearrangement how = Rearrangement::kSwap;
  double gain = 0.0;
};

/// A leg that is removed, given by its two ends.
struct CutLeg {
  LooseEnd one;
  LooseEnd other;
  Index position;
};

/// Finds the rearrangement that makes a tour from three removed legs and the new legs
/// one.other–two.one, two.other–three.one and three.other–one.one. Writes it to `exchange`.
/// @return false if the new legs make several separate rings
inline bool find_rearrangement(const CutLeg& one,
                               const CutLeg& two,
                               const CutLeg& three,
                               Exchange& exchange) {
  // Ends are numbered along the tour. The exit and the entry at the first cut are 0 and 1, at the
  // second cut 2 and 3, at the third cut 4 and 5.
  const auto rank = [](Index position, Index other, Index another) {
    return static_cast<std::size_t>(other < position) +
           static_cast<std::size_t>(another < position);
  };
  const std::size_t first = rank(one.position, two.position, three.position);
  const std::size_t second = rank(two.position, one.position, three.position);
  const std::size_t third = 3 - first - second;
  const auto number = [](std::size_t cut, const LooseEnd& end) {
    return 2 * cut + (end.is_entry ? 1 : 0);
  };
  std::array<std::size_t, 6> joined{};
  const auto join = [&](std::size_t a, std::size_t b) {
    joined[a] = b;
    joined[b] = a;
  };
  join(number(first, one.other), number(second, two.one));
  join(number(second, two.other), number(third, three.one));
  join(number(third, three.other), number(first, one.one));
  exchange.cuts[first] = one.position;
  exchange.cuts[second] = two.position;
  exchange.cuts[third] = three.position;
  exchange.has_three = true;
  if (joined[0] == 3 && joined[4] == 1) {
    exchange.how = Rearrangement::kSwap;
  } else if (joined[0] == 3 && joined[4] == 2) {
    exchange.how = Rearrangement::kSwapReverseFirst;
  } else if (joined[0] == 4 && joined[3] == 1) {
    exchange.how = Rearrangement::kSwapReverseSecond;
  } else if (joined[0] == 2 && joined[1] == 4) {
    exchange.how = Rearrangement::kReverseBoth;
  } else {
    return false;
  }
  return true;
}

/// Makes an exchange. If the tour may begin anywhere, the function moves as few sets as possible.
/// @param is_free see Problem::is_free()
void make_exchange(Tour& tour, const Exchange& exchange, bool is_free);

}  // namespace cnc::order
