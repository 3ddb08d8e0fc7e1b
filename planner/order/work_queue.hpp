#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "planner/order/problem.hpp"

namespace cnc::order {

struct WorkQueueSizes {
  std::size_t sets;
};

/// Storage of a WorkQueue.
struct WorkQueueSpace {
  std::span<Index> ring;
  std::span<std::uint8_t> is_waiting;

  template <typename Layout>
  void lay_out(Layout& layout, const WorkQueueSizes& sizes) {
    layout(ring, sizes.sets);
    layout(is_waiting, sizes.sets);
  }
};

/// Queue of the sets whose surroundings have changed since a search last tried them, in the order
/// in which they were added.
class WorkQueue {
 public:
  explicit WorkQueue(const WorkQueueSpace& space) : space_{space} {
    std::fill(space_.is_waiting.begin(), space_.is_waiting.end(), std::uint8_t{0});
  }

  [[nodiscard]] bool empty() const { return count_ == 0; }

  void add(Index set) {
    if (space_.is_waiting[set] != 0) return;
    space_.is_waiting[set] = 1;
    const std::size_t end = first_ + count_++;
    space_.ring[end < space_.ring.size() ? end : end - space_.ring.size()] = set;
  }

  /// Removes the oldest set and returns it. @pre !empty()
  Index take() {
    const Index set = space_.ring[first_];
    space_.is_waiting[set] = 0;
    first_ = first_ + 1 == space_.ring.size() ? 0 : first_ + 1;
    --count_;
    return set;
  }

 private:
  WorkQueueSpace space_;
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace cnc::order
