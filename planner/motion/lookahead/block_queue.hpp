#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/motion/lookahead/block_ring.hpp"
#include "planner/motion/lookahead/junction.hpp"
#include "planner/motion/lookahead/limit_zone.hpp"
#include "planner/motion/lookahead/plan_terms.hpp"

namespace cnc::motion {

/// Number of blocks that are planned ahead.
inline constexpr std::size_t kLookAheadBlocks = 128;

/// Least number of driven blocks that can be taken back. Motion is cut 20 ms and a few cycles
/// before it is driven. At 1,300 blocks per second, no more blocks than these are driven in that
/// time.
inline constexpr std::size_t kBlocksKept = 32;

/// Blocks that wait to be driven, oldest first, in a ring, and the look-ahead over them. The
/// capacity is in the type of the owner, BlockQueueOf.
///
/// The plan always ends at rest after the newest block, so it is valid at any moment. Blocks that
/// arrive can only make it faster. Planning waits until a speed is needed (`plan`), so a burst of
/// lines is planned once.
///
/// Driven blocks are kept in storage beyond the capacity, and in free space, until newer blocks
/// overwrite them. take_back() returns them to the queue.
///
/// Main loop only.
class BlockQueue : protected BlockRing {
 public:
  BlockQueue(const BlockQueue&) = delete;
  BlockQueue& operator=(const BlockQueue&) = delete;

  using BlockRing::capacity;
  using BlockRing::empty;
  using BlockRing::front;
  using BlockRing::full;
  using BlockRing::keep_all;
  using BlockRing::kept;
  using BlockRing::newest_kept;
  using BlockRing::size;
  using BlockRing::start;
  using BlockRing::start_of_front;
  /// Returns the block at `index`, counted from the oldest. @pre index < size()
  [[nodiscard]] const Block& at(std::size_t index) const { return BlockRing::at(index); }

  /// Adds a block, which begins from rest or continues the motion, see Joint. After an empty queue
  /// the machine is at rest.
  /// @pre !full()
  void push(const Block& block, Joint joint = Joint::kAsItTurns);
  void pop_front();
  /// Moves the block that was driven last back to the front. stand() and a plan of all blocks must
  /// follow.
  /// @pre kept() > 0, and the machine is at rest
  void take_back();
  /// Lets the motion begin from rest at `place`, with `front` instead of the block at the front.
  /// Forgets the blocks before it. @pre !empty()
  void begin_at(const AxisArray<StepPosition>& place, const Block& front);

  /// Prepares for the removal of the oldest block: its zone still holds in the blocks after it.
  /// @pre !empty()
  void leave_front(const Limits& limits, const PlanTerms& terms);
  /// Forgets the zones of removed blocks. Nothing moves, and the window never spans a stop.
  void stand();
  /// Forgets all blocks; the machine is at rest at `place`.
  void clear(const AxisArray<StepPosition>& place = {});

  /// Brings the entry speeds up to date from the block at `lead` on. Up to a sixteenth of the queue
  /// may stay unplanned at its far end. So several blocks share the cost of a pass over all of the
  /// queue, and the look-ahead is hardly shorter.
  void plan(const Limits& limits, const PlanTerms& terms, std::size_t lead = 0);
  /// Brings all entry speeds up to date from the block at `lead` on.
  void plan_all(const Limits& limits, const PlanTerms& terms, std::size_t lead = 0);
  /// Plans only the blocks from `lead` up to `end`, which ends at a stop, to evaluate that plan.
  /// The next plan is of all blocks again.
  /// @pre forget_plan() was called since the last plan of all blocks; end ≤ size()
  void plan_chain(const Limits& limits, const PlanTerms& terms, std::size_t lead, std::size_t end);
  /// Returns the running count of spans that plans have evaluated (wraps). A span of an arc counts
  /// twice, and under a window every span does. The caller budgets planning time with it.
  [[nodiscard]] std::uint32_t looked_at() const { return looked_at_; }
  /// Makes the next plan include all blocks, because no more come for a while.
  void leave_none_out() { leaves_none_out_ = unplanned_ > 0; }
  /// Marks the newest block as the last one known. A motion that starts from rest may take its end
  /// for a stop.
  void expect_no_more() { ends_ = true; }
  [[nodiscard]] bool ends() const { return ends_; }
  /// Makes the end of the newest block a stop: any block after it begins from rest.
  void stop_at_end() { stops_at_end_ = true; }
  /// Marks all blocks as unplanned, because limits or overrides have changed.
  void forget_plan() { unplanned_ = size(); }
  /// Refuses the blocks that the last plan included for the first time, because they came too late.
  /// The joint before them becomes a stop, so the plan without them holds.
  void stop_before_newest();
  /// Returns whether the last plan included blocks for the first time, the first of them after the
  /// block at `lead`.
  [[nodiscard]] bool has_newest_behind(std::size_t lead) const {
    return newest_ > 0 && newest_ < size() && size() - newest_ > lead;
  }

  /// Returns the running count of plans. While it stays the same, so does the state that each block
  /// must reach at its end.
  [[nodiscard]] std::uint32_t plans() const { return plans_; }
  /// Returns the state that a block must reach at its end. @pre the block is planned
  [[nodiscard]] BrakingState exit_of(std::size_t index) const {
    return index + 1 < size() ? at(index + 1).entry : BrakingState{};
  }

 protected:
  using BlockRing::BlockRing;
  ~BlockQueue() = default;

 private:
  [[nodiscard]] bool stops_before(const Block& block, Joint joint) const;

  void lay_heads(const Limits& limits, const PlanTerms& terms, std::size_t end);
  void plan_backwards(const Limits& limits,
                      const PlanTerms& terms,
                      std::size_t lead,
                      std::size_t end);

  static constexpr std::size_t kReplanShare = 16;

  AxisArray<float> last_exit_tangent_{};
  std::size_t unplanned_ = 0;  ///< Number of the newest blocks without an entry speed.
  std::size_t newest_ = 0;     ///< Number of blocks that the last plan was the first to include.
  bool leaves_none_out_ = false;
  bool ends_ = false;
  bool stops_at_end_ = false;
  std::uint32_t plans_ = 0;
  std::uint32_t looked_at_ = 0;

  // Zones that blocks impose on later blocks.
  ZoneTrail trail_{};              ///< Zones of the blocks that have a head.
  ZoneTrail front_trail_{};        ///< Zones of the blocks that were removed.
  float reachable_square_ = 0.0F;  ///< Greatest v² at the end of the newest block that has a head.
  float left_square_ = 0.0F;       ///< Greatest v² at the end of the block removed last.
};

/// Storage for blocks. It is a base class, so that it exists before the queue that uses it.
template <std::size_t kCapacity>
struct BlockStorage {
  std::array<Block, kCapacity> storage{};
};

/// A queue that owns the storage for `kCapacity` waiting blocks and `kKept` driven ones.
template <std::size_t kCapacity, std::size_t kKept = 0>
class BlockQueueOf final : private BlockStorage<kCapacity + kKept>, public BlockQueue {
  static_assert(kCapacity > 0);

 public:
  BlockQueueOf() : BlockQueue{this->storage, kKept} {}
};

}  // namespace cnc::motion
