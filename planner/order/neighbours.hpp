#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "planner/order/place_tree.hpp"
#include "planner/order/problem.hpp"

namespace cnc::order {

/// The sets nearest to each set, nearest first. A search tries only these sets as neighbours of the
/// set in the tour.
class Neighbours {
 public:
  Neighbours() = default;
  /// @param lists `width` sets for each set, filled up with kNone
  /// @param costs costs of the legs to these sets if the costs never change, otherwise empty
  Neighbours(std::span<const Index> lists, Index width, std::span<const double> costs = {})
      : lists_{lists}, costs_{costs}, width_{width} {}

  [[nodiscard]] bool have_costs() const { return !costs_.empty(); }
  /// Returns the cost of the leg to the neighbour with number `index` in the list of `set`.
  /// @pre have_costs()
  [[nodiscard]] double cost(Index set, Index index) const {
    return costs_[std::size_t{set} * width_ + index];
  }

  [[nodiscard]] std::span<const Index> of(Index set) const {
    return lists_.subspan(std::size_t{set} * width_, width_);
  }
  [[nodiscard]] Index width() const { return width_; }

 private:
  std::span<const Index> lists_;
  std::span<const double> costs_;
  Index width_ = 0;
};

/// Collects the nearest sets, each of them once.
class NearestSets {
 public:
  static constexpr Index kMaxWidth = 16;

  explicit NearestSets(Index width) : width_{width} {}

  /// Returns the distance below which another set is accepted.
  [[nodiscard]] double limit() const {
    return count_ < width_ ? std::numeric_limits<double>::infinity() : found_[count_ - 1].distance;
  }

  void offer(Index set, double distance) {
    if (!is_before({distance, set}, count_ < width_ ? kFarthest : found_[count_ - 1])) return;
    Index at = 0;
    while (at < count_ && found_[at].set != set) ++at;
    if (at == count_ && count_ < width_) ++count_;
    if (at == count_) --at;  // The offered set replaces the farthest set.
    if (found_[at].set == set && found_[at].distance <= distance) return;
    for (; at > 0 && is_before({distance, set}, found_[at - 1]); --at) found_[at] = found_[at - 1];
    found_[at] = {distance, set};
  }

  void write(std::span<Index> list) const {
    std::fill(list.begin(), list.end(), kNone);
    for (Index i = 0; i < count_; ++i) list[i] = found_[i].set;
  }

 private:
  struct Found {
    double distance;
    Index set;
  };
  static constexpr Found kFarthest{std::numeric_limits<double>::infinity(), kNone};
  static bool is_before(const Found& a, const Found& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.set < b.set);
  }

  std::array<Found, kMaxWidth> found_{};
  Index count_ = 0;
  Index width_;
};

/// Entries and exits of all candidates, for searches by distance.
struct CandidatePlaces {
  std::span<const Place> entry;
  /// Exits; may be the same span as `entry` if all contours are closed.
  std::span<const Place> exit;

  [[nodiscard]] bool are_closed() const { return entry.data() == exit.data(); }
};

/// Finds neighbours by distance in the plane. The distance of two sets is that of their nearest
/// points.
/// @param tree tree of all entries and, unless contours are closed, of all exits after them; all
///     points are present
/// @param set_of the set of each candidate
inline Neighbours find_neighbours(const Problem& problem,
                                  const CandidatePlaces& places,
                                  const PlaceTree& tree,
                                  std::span<const Index> set_of,
                                  Index width,
                                  std::span<Index> lists) {
  const Index candidates = problem.candidates();
  for (Index set = 0; set < problem.sets(); ++set) {
    NearestSets nearest{width};
    const auto search = [&](const Place& centre) {
      tree.search(centre, nearest.limit(), [&](Index place, double distance) {
        const Index other = set_of[place < candidates ? place : place - candidates];
        if (other != set) nearest.offer(other, distance);
        return nearest.limit();
      });
    };
    for (Index c = problem.first_candidate[set]; c < problem.first_candidate[set + 1]; ++c) {
      search(places.entry[c]);
      if (!places.are_closed()) search(places.exit[c]);
    }
    nearest.write(lists.subspan(std::size_t{set} * width, width));
  }
  return {lists, width};
}

/// Finds neighbours by the cost of legs in either direction. It compares all candidates, so it is
/// meant for explicit matrices.
template <LegCost Cost>
Neighbours find_neighbours(const Problem& problem,
                           const Cost& cost,
                           std::span<const Index> set_of,
                           Index width,
                           std::span<Index> lists) {
  for (Index set = 0; set < problem.sets(); ++set) {
    NearestSets nearest{width};
    for (Index c = problem.first_candidate[set]; c < problem.first_candidate[set + 1]; ++c) {
      for (Index other = 0; other < problem.candidates(); ++other) {
        if (set_of[other] == set) continue;
        nearest.offer(set_of[other], std::min(cost(c, other), cost(other, c)));
      }
    }
    nearest.write(lists.subspan(std::size_t{set} * width, width));
  }
  return {lists, width};
}

}  // namespace cnc::order
