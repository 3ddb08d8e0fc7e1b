#include "host-sim/import/wider_gap.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace sim::drawing {
namespace {

constexpr std::array<double, 5> kProposedGapsMm{0.02, 0.05, 0.1, 0.2, kWidestProposedGapMm};

/// One end of an open chain.
struct LooseEnd {
  Place place;
  std::size_t layer;
  std::size_t part;
};

struct LoosePair {
  double distance_mm;
  std::size_t first;
  std::size_t second;
  auto operator<=>(const LoosePair&) const = default;
};

/// Pairs loose ends that are within the widest gap, the nearest first.
class LooseEnds {
 public:
  void add(const LooseEnd& end) { ends_.push_back(end); }
  /// After the last add().
  void prepare() {
    cells_.reserve(ends_.size());
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      cells_.emplace_back(key_of(ends_[i].place, 0, 0), i);
    }
    std::ranges::sort(cells_);
  }

  [[nodiscard]] std::size_t count() const { return ends_.size(); }

  /// Returns the distances of pairs, not falling; each end is in one pair at most.
  [[nodiscard]] std::vector<double> paired_distances() const {
    std::vector<LoosePair> pairs;
    for (std::size_t end = 0; end < ends_.size(); ++end) {
      for (int cell = 0; cell < 9; ++cell) gather(end, cell % 3 - 1, cell / 3 - 1, pairs);
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

 private:
  using Key = std::uint64_t;

  static Key key_of(const Place& place, int dx, int dy) {
    const auto x = static_cast<std::int64_t>(std::floor(place.x() / kWidestProposedGapMm)) + dx;
    const auto y = static_cast<std::int64_t>(std::floor(place.y() / kWidestProposedGapMm)) + dy;
    return static_cast<Key>(x) * 0x9E37'79B9'7F4A'7C15U ^ static_cast<Key>(y);
  }

  void gather(std::size_t end, int dx, int dy, std::vector<LoosePair>& pairs) const {
    // Where more ends meet, a wider gap is no help.
    constexpr std::size_t kMostNeighbours = 16;
    const Key key = key_of(ends_[end].place, dx, dy);
    std::size_t found = 0;
    for (auto at = std::ranges::lower_bound(cells_, std::pair{key, end + 1});
         at != cells_.end() && at->first == key;
         ++at) {
      const std::size_t other = at->second;
      if (found == kMostNeighbours) return;
      const bool fits =
          ends_[other].layer == ends_[end].layer && ends_[other].part == ends_[end].part;
      const double apart = distance(ends_[end].place, ends_[other].place);
      if (!fits || apart > kWidestProposedGapMm) continue;
      pairs.push_back({apart, end, other});
      ++found;
    }
  }

  std::vector<LooseEnd> ends_;
  std::vector<std::pair<Key, std::size_t>> cells_;  ///< Sorted, with the ends in their order.
};

}  // namespace

std::optional<WiderGap> wider_gap(const std::vector<Piece>& chains, double gap_mm) {
  LooseEnds ends;
  double shortest_mm = std::numeric_limits<double>::infinity();
  for (const Piece& chain : chains) {
    const DrawnContour& contour = chain.contour;
    if (contour.length_mm <= gap_mm) continue;
    shortest_mm = std::min(shortest_mm, contour.length_mm);
    if (distance(chain.outline.front(), chain.outline.back()) <= gap_mm) continue;
    for (const Place& place : {chain.outline.front(), chain.outline.back()}) {
      ends.add({place, contour.entity.layer, contour.entity.part});
    }
  }
  ends.prepare();
  const std::vector<double> distances = ends.paired_distances();
  const auto within = [&](double gap) {
    return static_cast<std::size_t>(std::ranges::upper_bound(distances, gap) - distances.begin());
  };
  const std::size_t open = ends.count() - 2 * within(gap_mm);
  for (const double gap : kProposedGapsMm) {
    const std::size_t closing = 2 * (within(gap) - within(gap_mm));
    const std::size_t most = 2 * (distances.size() - within(gap_mm));
    if (gap <= gap_mm || gap >= shortest_mm || closing == 0) continue;
    if (2 * closing > open && 10 * closing >= 9 * most) return WiderGap{gap, open, closing};
  }
  return {};
}

}  // namespace sim::drawing
