#pragma once

#include <cstddef>
#include <span>

#include "planner/base/contract.hpp"
#include "planner/motion/block/block.hpp"

namespace cnc::motion {

/// Blocks in the order in which they are driven, in storage of fixed size: those that wait, oldest
/// first, and behind them in the ring those that were driven, as long as no newer one takes their
/// place. Blocks that wait have all of the storage but a share; driven ones have that and whatever
/// is free, and can return to the front.
///
/// It knows nothing of speeds: BlockQueue plans them. Main loop only.
class BlockRing {
 public:
  /// @param storage not empty; must outlive the ring
  /// @param kept share of it that driven blocks have at least
  BlockRing(std::span<Block> storage, std::size_t kept)
      : blocks_{storage}, capacity_{storage.size() - kept} {}

  /// Blocks that may wait.
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  /// With blocks that were taken back there may be more than capacity().
  [[nodiscard]] bool full() const {
    return size_ >= capacity_ || (keeps_all_ && size_ + kept_ == blocks_.size());
  }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Counted from the oldest. @pre index < size()
  [[nodiscard]] const Block& at(std::size_t index) const {
    CNC_ASSERT(index < size_);
    return blocks_[place_of(index)];
  }
  [[nodiscard]] Block& at(std::size_t index) { return blocks_[place_of(index)]; }
  /// The oldest block, the one being driven. @pre !empty()
  [[nodiscard]] const Block& front() const {
    CNC_ASSERT(size_ > 0);
    return blocks_[first_];
  }

  /// Number of driven blocks that can return.
  [[nodiscard]] std::size_t kept() const { return kept_; }
  /// Returns the one that was driven last. @pre kept() > 0
  [[nodiscard]] const Block& newest_kept() const { return blocks_[place_of(blocks_.size() - 1)]; }
  /// From now on no driven block is dropped for newer ones: the ring is full before; or no longer.
  void keep_all(bool keeps) { keeps_all_ = keeps; }

  /// Returns where the oldest block begins, driven ones that are kept included.
  [[nodiscard]] const AxisArray<StepPosition>& start() const { return start_; }
  /// Returns where the block at the front begins, or the next one will.
  [[nodiscard]] const AxisArray<StepPosition>& start_of_front() const {
    return kept_ == 0 ? start_ : newest_kept().end;
  }

  /// Adds a copy behind the newest, in the place of the oldest driven one if need be; returns it.
  /// @pre !full()
  Block& add(const Block& block) {
    CNC_ASSERT(!full());
    if (size_ + kept_ == blocks_.size()) {
      start_ = blocks_[place_of(blocks_.size() - kept_)].end;
      --kept_;
    }
    Block& added = blocks_[place_of(size_++)];
    added = block;
    return added;
  }
  /// The oldest block is one that was driven from now on. @pre !empty()
  void pass_front() {
    CNC_ASSERT(size_ > 0);
    first_ = place_of(1);
    --size_;
    ++kept_;
  }
  /// Returns the block that was driven last to the front. @pre kept() > 0
  void return_newest_kept() {
    CNC_ASSERT(kept_ > 0);
    first_ = place_of(blocks_.size() - 1);
    ++size_;
    --kept_;
  }
  /// The block at the front begins at `place`, and those before it are forgotten.
  void forget_kept(const AxisArray<StepPosition>& place) {
    kept_ = 0;
    start_ = place;
  }
  /// Forgets all blocks; the next one begins at `place`.
  void forget_all(const AxisArray<StepPosition>& place) {
    size_ = 0;
    keeps_all_ = false;
    forget_kept(place);
  }

 private:
  /// No division: the capacity is not a constant here.
  [[nodiscard]] std::size_t place_of(std::size_t index) const {
    const std::size_t place = first_ + index;
    return place < blocks_.size() ? place : place - blocks_.size();
  }

  std::span<Block> blocks_;
  std::size_t capacity_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::size_t kept_ = 0;  ///< Driven blocks before the first.
  bool keeps_all_ = false;
  AxisArray<StepPosition> start_{};  ///< Of the oldest block, kept ones included.
};

}  // namespace cnc::motion
