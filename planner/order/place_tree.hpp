#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "planner/order/precedence.hpp"

namespace cnc::order {

/// A point in the plane, in mm or any other unit.
struct Place {
  double x = 0.0;
  double y = 0.0;
};

[[nodiscard]] constexpr double squared_distance(const Place& a, const Place& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

struct PlaceTreeSizes {
  std::size_t places;
};

/// Storage of a PlaceTree.
struct PlaceTreeSpace {
  std::span<Index> items;
  std::span<Index> slots;
  std::span<Index> present;
  std::span<std::uint8_t> is_split_by_y;

  template <typename Layout>
  void lay_out(Layout& layout, const PlaceTreeSizes& sizes) {
    layout(items, sizes.places);
    layout(slots, sizes.places);
    layout(present, sizes.places);
    layout(is_split_by_y, sizes.places);
  }
};

/// Points sorted for searches by distance (a balanced k-d tree). Each point may be present or
/// absent.
///
/// A range of `items` is a subtree. Its middle item is the root, and its two halves are the
/// subtrees of the root. The division is along x or y, in the direction in which the points extend
/// farther. The result of a search depends only on the points, not on their order in the tree.
class PlaceTree {
 public:
  PlaceTree(std::span<const Place> places, const PlaceTreeSpace& space, bool are_present);

  void insert(Index place) { change(place, true); }
  void remove(Index place) { change(place, false); }
  [[nodiscard]] bool empty() const {
    return places_.empty() || space_.present[middle_of(all())] == 0;
  }

  /// Calls `visit(place, squared distance)` for present points around `centre`, near subtrees
  /// first. Each call of `visit` returns a limit. Points whose squared distance is certainly not
  /// below the latest limit are not visited.
  template <typename Visit>
  void search(const Place& centre, double limit, Visit&& visit) const {
    std::array<Open, kMaxDepth> open;  // NOLINT(cppcoreguidelines-pro-type-member-init)
    std::size_t count = 0;
    if (!empty()) open[count++] = {all(), 0.0};
    while (count > 0) {
      const Open next = open[--count];
      if (next.gap >= limit) continue;
      descend(centre, next.range, limit, visit, [&](const Open& far) { open[count++] = far; });
    }
  }

 private:
  struct Range {
    Index begin;
    Index end;
  };
  struct Open {
    Range range;
    double gap;  ///< Squared distance to the line that separates the subtree from the centre.
  };
  // Greatest number of subtrees that wait to be searched. A tree of 2^32 points has at most 33
  // levels, and on each level one half waits.
  static constexpr std::size_t kMaxDepth = 40;

  [[nodiscard]] Range all() const { return {0, static_cast<Index>(places_.size())}; }
  [[nodiscard]] static Index middle_of(Range range) {
    return range.begin + (range.end - range.begin) / 2;
  }

  void build();
  void split(Range range);
  void change(Index place, bool is_present);
  [[nodiscard]] Index present_in(Range range) const {
    return range.begin < range.end ? space_.present[middle_of(range)] : 0;
  }

  /// Descends towards the leaf on the side of `centre`. On each level, visits the middle point and
  /// passes the half on the other side to `keep`.
  template <typename Visit, typename Keep>
  void descend(const Place& centre, Range range, double& limit, Visit&& visit, Keep&& keep) const {
    while (present_in(range) > 0) {
      const Index middle = middle_of(range);
      const Place& place = places_[space_.items[middle]];
      Range near{range.begin, middle};
      Range far{middle + 1, range.end};
      const bool itself = present_in(range) > present_in(near) + present_in(far);
      if (itself) limit = visit(space_.items[middle], squared_distance(centre, place));
      const double gap =
          space_.is_split_by_y[middle] != 0 ? centre.y - place.y : centre.x - place.x;
      if (gap > 0.0) {
        const Range upper = far;
        far = near;
        near = upper;
      }
      if (gap * gap < limit && present_in(far) > 0) keep(Open{far, gap * gap});
      range = near;
    }
  }

  std::span<const Place> places_;
  PlaceTreeSpace space_;
};

}  // namespace cnc::order
