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

/// How far ahead a program is planned.
inline constexpr std::size_t kLookAheadBlocks = 128;

/// How many blocks behind the motion can be taken back at least. Motion is cut 20 ms and a few
/// cycles before it is driven: at 1,300 blocks per second these are as many blocks.
inline constexpr std::size_t kBlocksKept = 32;

/// Blocks waiting to be driven, oldest first, in a ring, and the look-ahead over them.
/// How many there is room for is in the type of its owner, BlockQueueOf.
///
/// The plan always ends at rest after the newest block, so it is valid at any
/// moment; blocks that arrive can only make it faster. Planning is left until
/// somebody asks for a speed (`plan`), so a burst of lines is planned once.
///
/// Blocks that were driven are kept in the capacity beyond that, and in what is free, until newer
/// ones take their place; take_back() returns them to the queue.
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
  /// Counted from the oldest. @pre index < size()
  [[nodiscard]] const Block& at(std::size_t index) const { return BlockRing::at(index); }

  /// Takes a block, which begins from rest or goes on, see Joint; after an empty
  /// queue the machine stands still.
  /// @pre !full()
  void push(const Block& block, Joint joint = Joint::kAsItTurns);
  void pop_front();
  /// Returns the block that was driven last to the front. stand() and a plan of all must follow.
  /// @pre kept() > 0, and the machine stands
  void take_back();
  /// The motion begins from rest at `place`, with `front` instead of the block at the front; the
  /// blocks before it are forgotten. @pre !empty()
  void begin_at(const AxisArray<StepPosition>& place, const Block& front);

  /// The oldest block is about to be taken away, but what it asks of those behind it still
  /// holds. @pre !empty()
  void leave_front(const Limits& limits, const PlanTerms& terms);
  /// Nothing moves: what is gone asks nothing any more, for the window never spans a stop.
  void stand();
  /// Forgets all blocks; the machine stands at `place`.
  void clear(const AxisArray<StepPosition>& place = {});

  /// Brings the entry speeds up to date from the block at `lead` on, but leaves up
  /// to a sixteenth of the queue unplanned at its far end: so the pass over all of
  /// it is paid for by several blocks, and the look-ahead is hardly shorter.
  void plan(const Limits& limits, const PlanTerms& terms, std::size_t lead = 0);
  /// The same, and leaves none unplanned.
  void plan_all(const Limits& limits, const PlanTerms& terms, std::size_t lead = 0);
  /// Only the blocks from `lead` up to `end`, which ends at a stop, to look at that plan: the next
  /// one is of all. @pre forget_plan() was called since the last plan of all, end ≤ size()
  void plan_chain(const Limits& limits, const PlanTerms& terms, std::size_t lead, std::size_t end);
  /// Returns the work of all plans so far, in spans that they have looked at, where a span of an
  /// arc counts twice. From this the time that planning takes is shared out. It runs freely.
  [[nodiscard]] std::uint32_t looked_at() const { return looked_at_; }
  /// Nothing comes for a while: the next plan leaves none of the blocks out.
  void leave_none_out() { leaves_none_out_ = unplanned_ > 0; }
  /// Nothing is known to follow the newest block: who starts from rest may take its end for
  /// a stop.
  void expect_no_more() { ends_ = true; }
  [[nodiscard]] bool ends() const { return ends_; }
  /// Its end has been taken for a stop: whatever comes after it begins from rest.
  void stop_at_end() { stops_at_end_ = true; }
  /// The limits or overrides changed: plan anew from the newest block on.
  void forget_plan() { unplanned_ = size(); }
  /// The blocks that were planned for the first time with the last plan came too
  /// late: the joint before them is taken at rest, so the plan without them holds.
  void stop_before_newest();
  /// There are such, and the first of them is behind the block at `lead`.
  [[nodiscard]] bool has_newest_behind(std::size_t lead) const {
    return newest_ > 0 && newest_ < size() && size() - newest_ > lead;
  }

  /// Counts the plans: while it stays, so does what any block must meet.
  [[nodiscard]] std::uint32_t plans() const { return plans_; }
  /// What a block must meet at its end. @pre planned
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
  std::size_t unplanned_ = 0;  ///< How many of the newest have no entry speed yet.
  std::size_t newest_ = 0;     ///< How many the last plan was the first of.
  bool leaves_none_out_ = false;
  bool ends_ = false;
  bool stops_at_end_ = false;
  std::uint32_t plans_ = 0;
  std::uint32_t looked_at_ = 0;

  // What blocks ask of those behind them.
  ZoneTrail trail_{};              ///< Of the blocks that have a head.
  ZoneTrail front_trail_{};        ///< Of those that were taken away.
  float reachable_square_ = 0.0F;  ///< v² with which the newest of the former may be left at most…
  float left_square_ = 0.0F;       ///< …and the block that was taken away last.
};

/// Room for blocks; a base, so that it is there before the queue that uses it.
template <std::size_t kCapacity>
struct BlockStorage {
  std::array<Block, kCapacity> storage{};
};

/// A queue that owns the storage for so many blocks, and for driven ones.
template <std::size_t kCapacity, std::size_t kKept = 0>
class BlockQueueOf final : private BlockStorage<kCapacity + kKept>, public BlockQueue {
  static_assert(kCapacity > 0);

 public:
  BlockQueueOf() : BlockQueue{this->storage, kKept} {}
};

}  // namespace cnc::motion
