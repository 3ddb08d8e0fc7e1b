#pragma once

#include <array>
#include <cstddef>

#include "planner/base/contract.hpp"
#include "planner/motion/block.hpp"
#include "planner/motion/limits.hpp"

namespace cnc::motion {

/// Blocks waiting to be driven, oldest first, with the look-ahead over them.
///
/// The plan always ends at rest after the newest block, so it is valid at any
/// moment; blocks that arrive can only make it faster. Planning is left until
/// somebody asks for a speed (`plan`), so a burst of lines is planned once.
///
/// Main loop only.
class BlockQueue {
 public:
  static constexpr std::size_t kCapacity = 64;

  [[nodiscard]] bool full() const { return size_ == kCapacity; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Takes a block and sets its corner speed from the block before; after an
  /// empty queue the machine stands still and so does the corner.
  /// @pre !full()
  void push(const Block& block, const Limits& limits);

  /// The oldest block, the one being driven. @pre !empty()
  [[nodiscard]] const Block& front() const {
    CNC_ASSERT(size_ > 0);
    return blocks_[first_];
  }
  void pop_front();
  void clear();

  /// Brings the entry speeds up to date, but leaves up to a sixteenth of the
  /// queue unplanned at its far end: so the pass over all of it is paid for by
  /// several blocks, and the look-ahead is hardly shorter.
  void plan(const Limits& limits, const Overrides& overrides);
  /// The limits or overrides changed: plan anew from the newest block on.
  void forget_plan();

  /// v² at which the front block must end. @pre planned
  [[nodiscard]] float front_exit_square() const {
    return size_ > 1 ? at(1).entry_speed_square : 0.0F;
  }

 private:
  [[nodiscard]] const Block& at(std::size_t index) const {
    return blocks_[(first_ + index) % kCapacity];
  }
  [[nodiscard]] Block& at(std::size_t index) { return blocks_[(first_ + index) % kCapacity]; }

  static constexpr std::size_t kReplanShare = 16;

  std::array<Block, kCapacity> blocks_{};
  AxisArray<float> last_exit_tangent_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::size_t unplanned_ = 0;  ///< How many of the newest have no entry speed yet.
};

}  // namespace cnc::motion
