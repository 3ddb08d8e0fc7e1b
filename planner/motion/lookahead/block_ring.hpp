#pragma once

#include <cstddef>
#include <span>

#include "planner/base/contract.hpp"
#include "planner/motion/block/block.hpp"

namespace cnc::motion {

/// Blocks in the order in which they are driven, in storage of fixed size. The waiting blocks come
/// first, oldest first. Driven blocks are kept in the rest of the ring, until newer blocks
/// overwrite them, and can return to the front. A part of the storage is reserved for driven
/// blocks. They also use the free space of the other part.
///
/// The ring does not compute speeds; BlockQueue does. Main loop only.
class BlockRing {
 public:
  /// @param storage not empty; must outlive the ring
  /// @param kept number of blocks of the storage that are reserved for driven blocks
  BlockRing(std::span<Block> storage, std::size_t kept)
      : blocks_{storage}, capacity_{storage.size() - kept} {}

  /// Returns the greatest number of waiting blocks. Only blocks that are taken back may exceed it.
  [[nodiscard]] std::size_t capacity() const { return capacity_; }
  /// Returns whether no block may be added. After blocks were taken back, more than capacity()
  /// blocks may be waiting.
  [[nodiscard]] bool full() const {
    return size_ >= capacity_ || (keeps_all_ && size_ + kept_ == blocks_.size());
  }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Returns the block at `index`, counted from the oldest. @pre index < size()
  [[nodiscard]] const Block& at(std::size_t index) const {
    CNC_ASSERT(index < size_);
    return blocks_[place_of(index)];
  }
  [[nodiscard]] Block& at(std::size_t index) { return blocks_[place_of(index)]; }
  /// Returns the oldest waiting block, which is being driven. @pre !empty()
  [[nodiscard]] const Block& front() const {
    CNC_ASSERT(size_ > 0);
    return blocks_[first_];
  }

  /// Returns the number of driven blocks that can return to the front.
  [[nodiscard]] std::size_t kept() const { return kept_; }
  /// Returns the block that was driven last. @pre kept() > 0
  [[nodiscard]] const Block& newest_kept() const { return blocks_[place_of(blocks_.size() - 1)]; }
  /// Sets whether all driven blocks are kept. If true, no newer block overwrites them: the ring
  /// counts as full when a new block would overwrite a driven one.
  void keep_all(bool keeps) { keeps_all_ = keeps; }

  /// Returns the start position of the oldest block, which may be a driven one.
  [[nodiscard]] const AxisArray<StepPosition>& start() const { return start_; }
  /// Returns the start position of the block at the front. If no block waits, returns the start
  /// position of the next block.
  [[nodiscard]] const AxisArray<StepPosition>& start_of_front() const {
    return kept_ == 0 ? start_ : newest_kept().end;
  }

  /// Adds a copy of a block after the newest one, and returns the copy. If there is no free space,
  /// the copy overwrites the oldest driven block.
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
  /// Makes the oldest waiting block a driven one. @pre !empty()
  void pass_front() {
    CNC_ASSERT(size_ > 0);
    first_ = place_of(1);
    --size_;
    ++kept_;
  }
  /// Moves the block that was driven last back to the front. @pre kept() > 0
  void return_newest_kept() {
    CNC_ASSERT(kept_ > 0);
    first_ = place_of(blocks_.size() - 1);
    ++size_;
    --kept_;
  }
  /// Forgets all driven blocks. The block at the front begins at `place`.
  void forget_kept(const AxisArray<StepPosition>& place) {
    kept_ = 0;
    start_ = place;
  }
  /// Forgets all blocks. The next block begins at `place`.
  void forget_all(const AxisArray<StepPosition>& place) {
    size_ = 0;
    keeps_all_ = false;
    forget_kept(place);
  }

 private:
  /// Returns the index in the storage of the block at `index`. It is computed without a division,
  /// which would be slow, because the size of the storage is not a constant here.
  [[nodiscard]] std::size_t place_of(std::size_t index) const {
    const std::size_t place = first_ + index;
    return place < blocks_.size() ? place : place - blocks_.size();
  }

  std::span<Block> blocks_;
  std::size_t capacity_;
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::size_t kept_ = 0;  ///< Number of driven blocks before the front.
  bool keeps_all_ = false;
  AxisArray<StepPosition> start_{};  ///< Start of the oldest block, which may be a driven one.
};

}  // namespace cnc::motion
