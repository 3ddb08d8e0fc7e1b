#include "host-sim/import/loose_ends.hpp"

#include <algorithm>
#include <cmath>

namespace sim::drawing {
namespace {

struct LoosePair {
  double distance_mm;
  std::size_t first;
  std::size_t second;
  auto operator<=>(const LoosePair&) const = default;
};

}  // namespace

void LooseEnds::prepare() { std::ranges::sort(cells_); }

std::vector<double> LooseEnds::paired_distances() const {
  // Greatest number of neighbours of an end that are checked. If more ends are near each other, a
  // wider gap does not help.
  constexpr std::size_t kMaxNeighbours = 16;
  std::vector<LoosePair> pairs;
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    std::size_t found = 0;
    visit_near(end, [&](std::size_t other, double apart) {
      if (other < end) return true;
      pairs.push_back({apart, end, other});
      return ++found < kMaxNeighbours;
    });
  }
  std::ranges::sort(pairs);
  std::vector<bool> taken(ends_.size(), false);
  std::vector<double> distances;
  for (const LoosePair& pair : pairs) {
    if (taken[pair.first] || taken[pair.second]) continue;
    taken[pair.first] = taken[pair.second] = true;
    distances.push_back(pair.distance_mm);
  }
  return distances;
}

LooseEnds::Neighbours LooseEnds::neighbours_of(std::size_t end) const {
  Neighbours found;
  visit_near(end, [&](std::size_t other, double apart) {
    found.first = other;
    found.apart_mm = apart;
    return ++found.count < 2;
  });
  return found;
}

bool LooseEnds::are_pair(std::size_t end, std::size_t other) const {
  const Neighbours of_end = neighbours_of(end);
  const Neighbours of_other = neighbours_of(other);
  return of_end.count == 1 && of_other.count == 1 && of_end.first == other;
}

bool LooseEnds::is_of_pair(std::size_t end, double max_mm) const {
  const Neighbours found = neighbours_of(end);
  return found.count == 1 && found.apart_mm <= max_mm && are_pair(end, found.first);
}

LooseEnds::Key LooseEnds::key_of(const Place& place, int dx, int dy) {
  const auto x = static_cast<std::int64_t>(std::floor(place.x() / kWidestProposedGapMm)) + dx;
  const auto y = static_cast<std::int64_t>(std::floor(place.y() / kWidestProposedGapMm)) + dy;
  return static_cast<Key>(x) * 0x9E37'79B9'7F4A'7C15U ^ static_cast<Key>(y);
}

template <typename Visit>
void LooseEnds::visit_near(std::size_t end, const Visit& visit) const {
  const LooseEnd& from = ends_[end];
  for (int number = 0; number < 9; ++number) {
    const Key key = key_of(from.place, number % 3 - 1, number / 3 - 1);
    for (auto at = std::ranges::lower_bound(cells_, std::pair{key, std::size_t{0}});
         at != cells_.end() && at->first == key;
         ++at) {
      const std::size_t other = at->second;
      const LooseEnd& to = ends_[other];
      if (other == end || to.layer != from.layer || to.part != from.part) continue;
      const double apart = distance(from.place, to.place);
      if (apart <= kWidestProposedGapMm && !visit(other, apart)) return;
    }
  }
}

}  // namespace sim::drawing
