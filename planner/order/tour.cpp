#include "planner/order/tour.hpp"

#include <algorithm>
#include <utility>

#include "planner/base/contract.hpp"

namespace cnc::order {

void Tour::assign(std::span<const Index> order, std::span<const Index> chosen) {
  std::copy(order.begin(), order.end(), space_.order.begin());
  std::copy(chosen.begin(), chosen.end(), space_.chosen.begin());
  for (Index i = 0; i < size(); ++i) space_.positions[space_.order[i]] = i;
  forget_changes();
}

void Tour::bring_home(Index home_candidate) {
  if (chosen(0) != home_candidate) move_reversed(0, size());
  const Index position = position_of(0);
  if (position > 0) move_swapped(0, position, size() - position);
  forget_changes();
}

void Tour::choose(Index set, Index candidate) {
  note({Change::Kind::kChoose, set, space_.chosen[set], 0});
  space_.chosen[set] = candidate;
}

void Tour::reverse(Index start, Index length) {
  note({Change::Kind::kReverse, start, length, 0});
  move_reversed(start, length);
}

void Tour::swap(Index start, Index first_length, Index second_length) {
  note({Change::Kind::kSwap, start, first_length, second_length});
  move_swapped(start, first_length, second_length);
}

void Tour::rearrange(Rearrangement how, Index start, Index first_length, Index second_length) {
  const bool reverses_both = how == Rearrangement::kReverseBoth;
  if (reverses_both || how == Rearrangement::kSwapReverseFirst) reverse(start, first_length);
  if (reverses_both || how == Rearrangement::kSwapReverseSecond) {
    reverse(wrapped(start + first_length), second_length);
  }
  if (!reverses_both) swap(start, first_length, second_length);
}

void Tour::take_back_changes() {
  CNC_ASSERT(can_note(0));
  while (noted_ > 0) {
    const Change& change = space_.changes[--noted_];
    switch (change.kind) {
      case Change::Kind::kReverse:
        move_reversed(change.a, change.b);
        break;
      case Change::Kind::kSwap:
        move_swapped(change.a, change.c, change.b);
        break;
      case Change::Kind::kChoose:
        space_.chosen[change.a] = change.b;
        break;
    }
  }
}

void Tour::move_reversed(Index start, Index length) {
  if (length == 0) return;
  Index low = start;
  Index high = wrapped(start + length - 1);
  for (Index i = 0; i < length / 2; ++i) {
    const Index first = at(low);
    const Index second = at(high);
    place(low, second);
    place(high, first);
    turn_round(first);
    turn_round(second);
    low = position_after(low);
    high = position_before(high);
  }
  if (length % 2 == 1) turn_round(at(low));
}

void Tour::move_swapped(Index start, Index first_length, Index second_length) {
  const Index second = wrapped(start + first_length);
  if (first_length <= second_length) {
    for (Index i = 0; i < first_length; ++i) space_.buffer[i] = at(wrapped(start + i));
    shift_down(second, second_length, first_length);
    for (Index i = 0; i < first_length; ++i) {
      place(wrapped(wrapped(start + second_length) + i), space_.buffer[i]);
    }
  } else {
    for (Index i = 0; i < second_length; ++i) space_.buffer[i] = at(wrapped(second + i));
    shift_up(start, first_length, second_length);
    for (Index i = 0; i < second_length; ++i) place(wrapped(start + i), space_.buffer[i]);
  }
}

void Tour::shift_down(Index from, Index length, Index by) {
  Index to = from >= by ? from - by : from + size() - by;
  for (Index i = 0; i < length; ++i) {
    place(to, at(from));
    to = position_after(to);
    from = position_after(from);
  }
}

void Tour::shift_up(Index from, Index length, Index by) {
  Index source = wrapped(from + length);
  Index to = wrapped(source + by);
  for (Index i = 0; i < length; ++i) {
    source = position_before(source);
    to = position_before(to);
    place(to, at(source));
  }
}

}  // namespace cnc::order
