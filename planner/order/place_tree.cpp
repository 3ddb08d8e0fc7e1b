#include "planner/order/place_tree.hpp"

#include <algorithm>

namespace cnc::order {

PlaceTree::PlaceTree(std::span<const Place> places, const PlaceTreeSpace& space, bool are_present)
    : places_{places}, space_{space} {
  for (Index i = 0; i < places_.size(); ++i) space_.items[i] = i;
  build();
  for (Index i = 0; i < places_.size(); ++i) space_.slots[space_.items[i]] = i;
  std::fill(space_.present.begin(), space_.present.end(), 0);
  if (are_present) {
    for (Index i = 0; i < places_.size(); ++i) insert(i);
  }
}

void PlaceTree::build() {
  std::array<Range, kMaxDepth> open{};
  std::size_t count = 0;
  open[count++] = all();
  while (count > 0) {
    const Range range = open[--count];
    if (range.begin == range.end) continue;
    split(range);
    const Index middle = middle_of(range);
    open[count++] = {range.begin, middle};
    open[count++] = {middle + 1, range.end};
  }
}

void PlaceTree::split(Range range) {
  const auto items = space_.items.subspan(range.begin, range.end - range.begin);
  Place least = places_[items[0]];
  Place greatest = least;
  for (const Index item : items) {
    const Place& place = places_[item];
    least = {std::min(least.x, place.x), std::min(least.y, place.y)};
    greatest = {std::max(greatest.x, place.x), std::max(greatest.y, place.y)};
  }
  const bool by_y = greatest.y - least.y > greatest.x - least.x;
  const Index middle = middle_of(range);
  // For equal coordinates the index decides, so that every implementation of the standard library
  // builds the same tree.
  std::nth_element(
      items.begin(), items.begin() + (middle - range.begin), items.end(), [&](Index a, Index b) {
        const double one = by_y ? places_[a].y : places_[a].x;
        const double other = by_y ? places_[b].y : places_[b].x;
        return one < other || (one == other && a < b);
      });
  space_.is_split_by_y[middle] = by_y ? 1 : 0;
}

void PlaceTree::change(Index place, bool is_present) {
  const Index slot = space_.slots[place];
  Range range = all();
  for (;;) {
    const Index middle = middle_of(range);
    space_.present[middle] += is_present ? 1U : ~0U;
    if (slot == middle) return;
    range = slot < middle ? Range{range.begin, middle} : Range{middle + 1, range.end};
  }
}

}  // namespace cnc::order
