#pragma once

#include <array>
#include <utility>

#include "planner/order/legs.hpp"

namespace cnc::order {

/// Two or three legs of a tour replaced by others: the tour is cut behind the positions `cuts`,
/// ascending, and its stretches are put together in another way.
struct Exchange {
  std::array<Index, 3> cuts{};
  bool has_three = false;
  Rearrangement how = Rearrangement::kSwap;  ///< With three legs; two legs reverse a stretch.
  double gain = 0.0;
};

/// A leg that is taken away, by both of its ends.
struct CutLeg {
  LooseEnd one;
  LooseEnd other;
  Index position;
};

/// Fills in which rearrangement makes a tour out of three legs that are taken away and the new legs
/// one.other–two.one, two.other–three.one and three.other–one.one.
/// @return false where these new legs leave several rings
inline bool find_rearrangement(const CutLeg& one,
                               const CutLeg& two,
                               const CutLeg& three,
                               Exchange& exchange) {
  // Ends are numbered along the tour: exit and entry at the first cut are 0 and 1, and so on.
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

/// Makes an exchange, moving as few sets as possible where the tour may begin anywhere.
/// @param is_free see Problem::is_free()
void make_exchange(Tour& tour, const Exchange& exchange, bool is_free);

}  // namespace cnc::order
