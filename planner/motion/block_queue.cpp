#include "planner/motion/block_queue.hpp"

#include <algorithm>

#include "planner/motion/block_builder.hpp"
#include "planner/motion/braking.hpp"

namespace cnc::motion {

void BlockQueue::push(const Block& block, Joint joint) {
  CNC_ASSERT(!full());
  Block& added = at(size_);
  added = block;
  added.corner_speed_square = corner_after(block, joint);
  added.entry_speed_square = 0.0F;
  last_exit_tangent_ = exit_tangent(block);
  ++size_;
  ++unplanned_;
}

float BlockQueue::corner_after(const Block& block, Joint joint) const {
  if (empty() || joint == Joint::kStop) return 0.0F;
  if (joint == Joint::kSmooth) return kNoCornerLimit;
  return corner_speed_square(last_exit_tangent_, entry_tangent(block));
}

void BlockQueue::pop_front() {
  CNC_ASSERT(size_ > 0);
  first_ = place_of(1);
  --size_;
  unplanned_ = std::min(unplanned_, size_);
}

void BlockQueue::clear() {
  size_ = 0;
  unplanned_ = 0;
}

void BlockQueue::forget_plan() { unplanned_ = size_; }

// Backward pass from the newest block. Where a block that was planned before
// gets the same entry speed again, all older ones would, too.
void BlockQueue::plan(const Limits& limits, const Overrides& overrides) {
  if (unplanned_ == 0 || unplanned_ * kReplanShare < size_) return;
  float exit_square = 0.0F;
  for (std::size_t index = size_; index-- > 1;) {
    Block& block = at(index);
    const float reachable =
        brake_backwards(Spans{block, limits}, SpeedCap{block, overrides}, exit_square);
    const float entry = std::min(reachable, block.corner_speed_square);
    const bool was_planned = index < size_ - unplanned_;
    if (was_planned && entry == block.entry_speed_square) break;
    block.entry_speed_square = entry;
    exit_square = entry;
  }
  unplanned_ = 0;
}

}  // namespace cnc::motion
