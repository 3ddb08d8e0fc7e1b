#include "host-sim/import/end_matcher.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/import/loose_ends.hpp"

namespace sim::drawing {

EndMatcher::EndMatcher(const std::vector<Piece>& chains, double gap_mm)
    : chains_{chains},
      gap_{std::max(gap_mm, kSamePlaceMm)},
      partner_(2 * chains.size(), kNoEnd),
      among_others_(partner_.size(), false) {
  cells_.reserve(partner_.size());
  for (EndIndex end = 0; end < partner_.size(); ++end) {
    cells_.emplace_back(key_of(place(end), 0, 0), end);
  }
  std::ranges::sort(cells_);
  gather_pairs();
  std::ranges::sort(pairs_);
  for (const EndPair& pair : pairs_) {
    if (partner_[pair.first] != kNoEnd || partner_[pair.second] != kNoEnd) continue;
    partner_[pair.first] = pair.second;
    partner_[pair.second] = pair.first;
  }
}

CertainGaps EndMatcher::pair_certain() {
  LooseEnds loose;
  std::vector<EndIndex> of;  // Ends of chains, in the order in which they were added to `loose`.
  for (EndIndex end = 0; end < partner_.size(); ++end) {
    if (partner_[end] != kNoEnd || among_others_[end]) continue;
    loose.add(place(end), chains_[end / 2].contour.entity);
    of.push_back(end);
  }
  loose.prepare();
  CertainGaps gaps;
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (partner_[of[i]] != kNoEnd || !loose.is_of_pair(i, kWidestCertainGapMm)) continue;
    const LooseEnds::Neighbours other = loose.neighbours_of(i);
    if (of[other.first] / 2 == of[i] / 2) continue;
    partner_[of[i]] = of[other.first];
    partner_[of[other.first]] = of[i];
    gaps.widest.take_greater(other.apart_mm, place(of[i]));
    ++gaps.count;
  }
  return gaps;
}

EndMatcher::Key EndMatcher::key_of(const Place& place, int dx, int dy) const {
  const auto x = static_cast<std::int64_t>(std::floor(place.x() / gap_)) + dx;
  const auto y = static_cast<std::int64_t>(std::floor(place.y() / gap_)) + dy;
  return static_cast<Key>(x) * 0x9E37'79B9'7F4A'7C15U ^ static_cast<Key>(y);
}

void EndMatcher::gather_pairs() {
  for (EndIndex end = 0; end < partner_.size(); ++end) {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) gather_in(end, key_of(place(end), dx, dy));
    }
  }
}

void EndMatcher::gather_in(EndIndex end, Key key) {
  // Greatest number of neighbours of one end that are checked in one cell. A drawing made for
  // cutting does not have more neighbours at a point.
  constexpr std::size_t kMaxEndsAtAPlace = 16;
  std::size_t found = 0;
  for (auto at = std::ranges::lower_bound(cells_, std::pair{key, end + 1});
       at != cells_.end() && at->first == key && found < kMaxEndsAtAPlace;
       ++at) {
    const EndIndex other = at->second;
    if (other / 2 == end / 2) continue;
    if (!same_layer(end, other)) continue;
    const double apart = distance(place(end), place(other));
    if (apart > gap_) continue;
    pairs_.push_back({apart, end, other});
    among_others_[end] = among_others_[other] = true;
    ++found;
  }
}

bool EndMatcher::same_layer(EndIndex a, EndIndex b) const {
  const Entity& first = chains_[a / 2].contour.entity;
  const Entity& second = chains_[b / 2].contour.entity;
  return first.layer == second.layer && first.part == second.part;
}

}  // namespace sim::drawing
