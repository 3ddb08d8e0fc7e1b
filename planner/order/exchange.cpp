#include "planner/order/exchange.hpp"

namespace cnc::order {
namespace {

/// Returns the rearrangement of the stretch C and the rest of the tour that gives the same cyclic
/// tour as the rearrangement `how` of the stretches B and C (see Rearrangement). The tour may run
/// in the opposite direction. Applied twice, the function gives the rearrangement of the rest and
/// B. The table was found by writing out each case.
Rearrangement without_moving_first(Rearrangement how) {
  switch (how) {
    case Rearrangement::kSwap:
      return Rearrangement::kSwap;
    case Rearrangement::kSwapReverseFirst:
      return Rearrangement::kReverseBoth;
    case Rearrangement::kSwapReverseSecond:
      return Rearrangement::kSwapReverseFirst;
    case Rearrangement::kReverseBoth:
      return Rearrangement::kSwapReverseSecond;
  }
  return how;
}

Rearrangement without_moving_second(Rearrangement how) {
  return without_moving_first(without_moving_first(how));
}

}  // namespace

void make_exchange(Tour& tour, const Exchange& exchange, bool is_free) {
  const auto [p, q, r] = exchange.cuts;
  const Index first_length = q - p;
  if (!exchange.has_three) {
    if (is_free && 2 * first_length > tour.size()) {
      tour.reverse(tour.position_after(q), tour.size() - first_length);
    } else {
      tour.reverse(p + 1, first_length);
    }
    return;
  }
  const Index second_length = r - q;
  const Index rest = tour.size() - first_length - second_length;
  if (is_free && first_length > rest && first_length >= second_length) {
    // NOLINTNEXTLINE(readability-suspicious-call-argument): here other stretches are rearranged.
    tour.rearrange(without_moving_first(exchange.how), q + 1, second_length, rest);
  } else if (is_free && second_length > rest) {
    // NOLINTNEXTLINE(readability-suspicious-call-argument): here other stretches are rearranged.
    tour.rearrange(without_moving_second(exchange.how), tour.position_after(r), rest, first_length);
  } else {
    tour.rearrange(exchange.how, p + 1, first_length, second_length);
  }
}

}  // namespace cnc::order
