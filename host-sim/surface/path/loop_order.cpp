#include "host-sim/surface/path/loop_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// Points of loops, sorted into squares of the plan to find near points quickly.
class PlaceIndex {
 public:
  explicit PlaceIndex(double near_mm) : near_mm_{near_mm} {}

  void add(std::size_t loop, const std::vector<Vector2d>& places) {
    for (const Vector2d& place : places) squares_[square_of(place)].push_back({place, loop});
  }

  void add_near(const Vector2d& place, std::set<std::size_t>& loops) const {
    const auto [column, row] = square_of(place);
    for (std::int64_t y = row - 1; y <= row + 1; ++y) {
      for (std::int64_t x = column - 1; x <= column + 1; ++x) {
        const auto found = squares_.find({x, y});
        if (found == squares_.end()) continue;
        for (const auto& [other, loop] : found->second) {
          if ((other - place).norm() <= near_mm_) loops.insert(loop);
        }
      }
    }
  }

 private:
  using Square = std::pair<std::int64_t, std::int64_t>;

  [[nodiscard]] Square square_of(const Vector2d& place) const {
    return {std::llround(place.x() / near_mm_), std::llround(place.y() / near_mm_)};
  }

  double near_mm_;
  std::map<Square, std::vector<std::pair<Vector2d, std::size_t>>> squares_;
};

double distance_to(const LevelLoop& loop, const Vector2d& here) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2d& place : loop.places) {
    least = std::min(least, (place - here).norm());
    if (!loop.is_closed) break;  // An open loop can only begin at its first point.
  }
  return least;
}

}  // namespace

LoopOrder::LoopOrder(const std::vector<LevelLoop>& loops, double near_mm)
    : loops_{&loops},
      lower_(loops.size()),
      waits_for_(loops.size(), 0),
      is_taken_(loops.size(), false) {
  std::size_t above = 0;  // Index of the first loop of the previous level.
  for (std::size_t begin = 0; begin < loops.size();) {
    std::size_t end = begin;
    while (end < loops.size() && loops[end].level == loops[begin].level) ++end;
    if (begin > 0 && loops[above].level + 1 == loops[begin].level) {
      PlaceIndex higher{near_mm};
      for (std::size_t i = above; i < begin; ++i) higher.add(i, loops[i].places);
      for (std::size_t i = begin; i < end; ++i) {
        std::set<std::size_t> near;
        for (const Vector2d& place : loops[i].places) higher.add_near(place, near);
        for (const std::size_t other : near) lower_[other].push_back(i);
        waits_for_[i] = near.size();
      }
    }
    above = begin;
    begin = end;
  }
}

LoopOrder::LoopOrder(const std::vector<LevelLoop>& loops,
                     std::vector<std::vector<std::size_t>> lower)
    : loops_{&loops},
      lower_{std::move(lower)},
      waits_for_(loops.size(), 0),
      is_taken_(loops.size(), false) {
  for (const std::vector<std::size_t>& waiting : lower_) {
    for (const std::size_t loop : waiting) ++waits_for_[loop];
  }
}

std::optional<std::size_t> LoopOrder::take_next(const Vector2d& here) {
  while (!ready_.empty()) {
    std::vector<std::size_t>& group = ready_.back();
    std::erase_if(group, [this](std::size_t loop) { return is_taken_[loop]; });
    if (const auto nearest = nearest_of(group, here)) return take(*nearest);
    ready_.pop_back();
  }
  const auto nearest = nearest_of(highest_left(), here);
  if (!nearest) return std::nullopt;
  return take(*nearest);
}

std::size_t LoopOrder::take(std::size_t loop) {
  is_taken_[loop] = true;
  std::vector<std::size_t> group;
  for (const std::size_t other : lower_[loop]) {
    if (--waits_for_[other] == 0) group.push_back(other);
  }
  if (!group.empty()) ready_.push_back(std::move(group));
  return loop;
}

std::optional<std::size_t> LoopOrder::nearest_of(const std::vector<std::size_t>& loops,
                                                 const Vector2d& here) const {
  const auto nearest = std::ranges::min_element(
      loops, {}, [&](std::size_t loop) { return distance_to((*loops_)[loop], here); });
  if (nearest == loops.end()) return std::nullopt;
  return *nearest;
}

/// Returns the remaining loops of the highest level that has remaining loops.
std::vector<std::size_t> LoopOrder::highest_left() {
  while (first_left_ < is_taken_.size() && is_taken_[first_left_]) ++first_left_;
  std::vector<std::size_t> left;
  for (std::size_t i = first_left_; i < is_taken_.size(); ++i) {
    if ((*loops_)[i].level != (*loops_)[first_left_].level) break;
    if (!is_taken_[i]) left.push_back(i);
  }
  return left;
}

}  // namespace sim::surface
