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

/// Number of blocks that are planned ahead of the motion.
inline constexpr std::size_t kLookAheadBlocks = 128;

/// Least number of driven blocks that can be taken back. Segments of a motion are made up to 20 ms
/// and a few cycles of the main loop before they are driven. At 1,300 blocks per second, at most
/// this number of blocks is driven in that time.
inline constexpr std::size_t kBlocksKept = 32;

/// Blocks that wait to be driven, oldest first, in a ring, and their look-ahead. The capacity is in
/// the type of the derived class, BlockQueueOf.
///
/// The plan always ends at rest after the newest block, so it is valid at any time. Blocks that are
/// added can only make the plan faster. Planning waits until a speed is required (`plan`), so
/// blocks that arrive together are planned together.
///
/// Driven blocks are kept until newer blocks overwrite them. The storage has additional space for
/// driven blocks, which also use the free space for waiting blocks. take_back() returns driven
/// blocks to the queue.
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

  /// Adds a block, which begins from rest or continues the motion, see Joint. If the queue was
  /// empty, the block begins from rest.
  /// @pre !full()
  void push(const Block& block, Joint joint = Joint::kAsItTurns);
  void pop_front();
  /// Moves the block that was driven last back to the front of the queue. After this, stand() and a
  /// plan of all blocks are required.
  /// @pre kept() > 0, and the machine is at rest
  void take_back();
  /// Replaces the block at the front by `front`, which begins from rest at `place`. Forgets all
  /// driven blocks. @pre !empty()
  void begin_at(const AxisArray<StepPosition>& place, const Block& front);

  /// Prepares for the removal of the oldest block: keeps its limit zone, which still holds in the
  /// blocks after it. @pre !empty()
  void leave_front(const Limits& limits, const PlanTerms& terms);
  /// Forgets the limit zones of removed blocks, because the machine is at rest and the time window
  /// never spans a stop.
  void stand();
  /// Forgets all blocks. The machine is at rest at `place`.
  void clear(const AxisArray<StepPosition>& place = {});

  /// Updates the entry speeds of the blocks after index `lead`. Up to a sixteenth of the queue may
  /// stay unplanned at its newest end. So several new blocks share the cost of one pass over the
  /// queue, and the look-ahead is hardly shorter.
  void plan(const Limits& limits, const PlanTerms& terms, std::size_t lead = 0);
  /// Updates the entry speeds of all blocks after index `lead`.
  void plan_all(const Limits& limits, const PlanTerms& terms, std::size_t lead = 0);
  /// Plans only the blocks from index `lead` to index `end` − 1, as if the path stopped after them,
  /// so that the caller can evaluate this plan. The next plan must include all blocks again.
  /// @pre forget_plan() was called after the last plan of all blocks; end ≤ size()
  void plan_chain(const Limits& limits, const PlanTerms& terms, std::size_t lead, std::size_t end);
  /// Returns the running count of spans that plans have evaluated (wraps). A span of an arc counts
  /// twice, and so does every span under a time window. The caller budgets planning time with this
  /// count.
  [[nodiscard]] std::uint32_t looked_at() const { return looked_at_; }
  /// Makes the next plan include all blocks. To be called if no further block will come for some
  /// time.
  void leave_none_out() { leaves_none_out_ = unplanned_ > 0; }
  /// Marks the newest block as the last known one. A motion that starts from rest may then treat
  /// the end of this block as a stop.
  void expect_no_more() { ends_ = true; }
  [[nodiscard]] bool ends() const { return ends_; }
  /// Makes the end of the newest block a stop: a block that is added after it begins from rest.
  void stop_at_end() { stops_at_end_ = true; }
  /// Marks all blocks as unplanned, because limits or overrides have changed.
  void forget_plan() { unplanned_ = size(); }
  /// Makes the joint before the blocks that were new in the last plan a stop, because these blocks
  /// came too late. So the plan without these blocks stays valid.
  void stop_before_newest();
  /// Returns whether the last plan included new blocks, all of which are after the block at index
  /// `lead`.
  [[nodiscard]] bool has_newest_behind(std::size_t lead) const {
    return newest_ > 0 && newest_ < size() && size() - newest_ > lead;
  }

  /// Returns the running count of plans. The state that each block must reach at its end changes
  /// only when this count changes.
  [[nodiscard]] std::uint32_t plans() const { return plans_; }
  /// Returns the state that the block at `index` must reach at its end. @pre the block is planned
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
  std::size_t unplanned_ = 0;  ///< Number of blocks at the newest end that are not planned.
  std::size_t newest_ = 0;     ///< Number of blocks that were new in the last plan.
  bool leaves_none_out_ = false;
  bool ends_ = false;
  bool stops_at_end_ = false;
  std::uint32_t plans_ = 0;
  std::uint32_t looked_at_ = 0;

  // Limit zones that blocks impose on later blocks, and the greatest speeds after these blocks.
  ZoneTrail trail_{};        ///< Limit zones of the blocks whose `head` is set.
  ZoneTrail front_trail_{};  ///< Limit zones of the removed blocks.
  /// Greatest v² at the end of the newest block whose `head` is set.
  float reachable_square_ = 0.0F;
  float left_square_ = 0.0F;  ///< Greatest v² at the end of the block that was removed last.
};

/// Storage for blocks. It is a base class of the queue, so that it exists before BlockQueue uses
/// it.
template <std::size_t kCapacity>
struct BlockStorage {
  std::array<Block, kCapacity> storage{};
};

/// A queue that owns the storage for `kCapacity` waiting blocks and at least `kKept` driven ones.
template <std::size_t kCapacity, std::size_t kKept = 0>
class BlockQueueOf final : private BlockStorage<kCapacity + kKept>, public BlockQueue {
  static_assert(kCapacity > 0);

 public:
  BlockQueueOf() : BlockQueue{this->storage, kKept} {}
};

}  // namespace cnc::motion
