#include "host-sim/surface/path/part_queue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sim::surface {
namespace {

/// Follows links to an index that links to itself. Shortens the links to accelerate later searches.
std::size_t followed(std::vector<std::size_t>& links, std::size_t index) {
  while (links[index] != index) {
    links[index] = links[links[index]];
    index = links[index];
  }
  return index;
}

}  // namespace

PartQueue::PartQueue(std::vector<RowPart> parts)
    : parts_{std::move(parts)},
      above_(parts_.size() + 1),
      below_(parts_.size() + 1),
      count_{parts_.size()} {
  std::ranges::sort(parts_, {}, [](const RowPart& part) {
    return std::pair{part.row, part.begin};
  });
  std::iota(above_.begin(), above_.end(), std::size_t{0});
  std::iota(below_.begin(), below_.end(), std::size_t{0});
}

/// Returns the index of the first waiting part at or after `index`; the number of parts if there is
/// none.
std::size_t PartQueue::waiting_from(std::size_t index) { return followed(above_, index); }

/// Returns the index of the last waiting part before `index`, plus one; 0 if there is none.
std::size_t PartQueue::waiting_before(std::size_t index) { return followed(below_, index); }

void PartQueue::consider(std::size_t index,
                         const Eigen::Vector2d& seen,
                         bool may_go_back,
                         Found& found) {
  const RowPart& part = parts_[index];
  for (const bool goes_back : {false, true}) {
    if (goes_back && !may_go_back) continue;
    const double along = goes_back ? part.end : part.begin;
    const double distance = std::hypot(along - seen.x(), part.row - seen.y());
    if (distance < found.distance) found = {index, distance, goes_back};
  }
}

PartQueue::Next PartQueue::take_nearest(const Eigen::Vector2d& seen, bool may_go_back) {
  const auto first = std::ranges::lower_bound(parts_, seen.y(), {}, &RowPart::row);
  const auto middle = static_cast<std::size_t>(first - parts_.begin());
  std::size_t above = waiting_from(middle);
  std::size_t below = waiting_before(middle);
  Found found{0, std::numeric_limits<double>::infinity(), false};
  while (above < parts_.size() || below > 0) {
    const double up = above < parts_.size() ? parts_[above].row - seen.y()
                                            : std::numeric_limits<double>::infinity();
    const double down =
        below > 0 ? seen.y() - parts_[below - 1].row : std::numeric_limits<double>::infinity();
    if (std::min(up, down) >= found.distance) break;
    if (up <= down) {
      consider(above, seen, may_go_back, found);
      above = waiting_from(above + 1);
    } else {
      consider(below - 1, seen, may_go_back, found);
      below = waiting_before(below - 1);
    }
  }
  return take(found.index, found.goes_back);
}

PartQueue::Next PartQueue::take_outermost(bool is_highest) {
  if (!is_highest) return take(waiting_from(0), false);
  std::size_t index = waiting_before(parts_.size()) - 1;
  for (std::size_t before = waiting_before(index);
       before > 0 && parts_[before - 1].row == parts_[index].row;
       before = waiting_before(index)) {
    index = before - 1;
  }
  return take(index, false);
}

PartQueue::Next PartQueue::take(std::size_t index, bool goes_back) {
  above_[index] = index + 1;
  below_[index + 1] = index;
  --count_;
  return {parts_[index], goes_back};
}

}  // namespace sim::surface
