#pragma once

#include <cstddef>

#include "planner/motion/lookahead/block_queue.hpp"
#include "planner/motion/plan/phase_clock.hpp"
#include "planner/motion/plan/phase_course.hpp"
#include "planner/motion/plan/speed_profile.hpp"

namespace cnc::motion {

/// Moves the plan through the blocks of a queue as time passes. The plan is a position and a speed
/// that keep the limits of speed and acceleration.
///
/// The object that drives the motors removes blocks from the queue, possibly some time after the
/// plan has left them. It calls block_left() before each removal. Added blocks, an override or a
/// feed hold take effect with the next stretch.
///
/// Main loop only.
class PlanCursor {
 public:
  PlanCursor(BlockQueue& queue, const Limits& limits) : queue_{queue}, limits_{limits} {}

  /// Returns the next stretch, which lasts at most `max_ns` and is within one block and one phase.
  /// Its duration is 0 if the plan is at rest: it has reached the end of the queue, it is halted,
  /// or `may_start` is false.
  [[nodiscard]] Stretch next(std::uint32_t max_ns, Drive drive, bool may_start);

  /// Sets the overrides. Without a time window they take effect immediately. Under a window, lower
  /// overrides take effect immediately, too. Higher overrides take effect as soon as the position
  /// and the speed allow a change to the faster plan.
  void set_overrides(const Overrides& overrides);
  /// Returns the overrides as last requested.
  [[nodiscard]] const Overrides& overrides() const { return overrides_; }

  /// Sets the time window over which the motion is the mean of the plan. @pre at rest
  void set_window(const TimeWindow& window);
  /// Returns the best time window for the path to the next stop, or the longest window if that stop
  /// is not known yet. If the window is not the longest one, blocks that are added later begin from
  /// rest, because the window was not chosen for them.
  /// @pre at rest, not at_end()
  [[nodiscard]] TimeWindow choose_window();

  /// Prepares for the removal of the block at the front of the queue. @pre the plan has left this
  /// block
  void block_left();
  /// Returns the number of blocks at the front of the queue that the plan has left. The next
  /// stretch is in the block after them.
  [[nodiscard]] std::size_t blocks_left() const { return index_; }
  /// Forgets the plan. The next stretch begins from rest, with the block at index 0 of the queue.
  void reset();

  /// Returns the speed of the plan, in mm/s.
  [[nodiscard]] float speed() const { return speed_; }
  /// Returns whether the plan has reached the end of the queue.
  [[nodiscard]] bool at_end() const { return !driving_ && index_ == queue_.size(); }

 private:
  [[nodiscard]] std::size_t chain_end() const;
  [[nodiscard]] TimeWindow quickest(const WindowChoice& choice, std::size_t end);
  [[nodiscard]] std::uint64_t time_to(std::size_t end, const TimeWindow& window);
  [[nodiscard]] Patience patience() const;
  [[nodiscard]] Stretch follow(std::uint32_t max_ns, Drive drive, bool may_start);
  void note_change(const Stretch& stretch);
  void stop_phase_short();
  void settle_place();
  [[nodiscard]] bool goes_on() const;
  void follow_plan(Drive drive);
  void plan_for(const PlanTerms& terms);
  void take_up_overrides();
  void bring_up_to_date(Drive drive);
  void lower_pace(std::uint64_t passed_ns, Drive drive);
  void try_higher_pace(std::uint64_t passed_ns, Drive drive);
  void plan_and_replan(const PlanTerms& terms);
  void replan();
  void refuse_late_blocks();
  [[nodiscard]] Stretch finish_block();
  [[nodiscard]] bool begin_phase(Drive drive);
  [[nodiscard]] Stretch pass(std::uint32_t max_ns);
  void end_phase();
  void stand_at_stop();
  void begin_block();
  void end_block();
  [[nodiscard]] PathUnits way_in_time(PathUnits way);
  [[nodiscard]] PathUnits place_after(const Phase& phase) const;
  [[nodiscard]] float phase_distance_left() const;

  static constexpr std::uint32_t kLongAgo = 1'000'000'000;

  BlockQueue& queue_;
  const Limits& limits_;
  SpeedProfile profile_{};  ///< Profile of the block in which the plan is.
  /// Overrides as last requested; the current plan may still use older ones.
  Overrides overrides_{};
  PlanTerms terms_{};
  std::uint64_t untried_ns_ = 0;    ///< Time since higher overrides were last tried.
  std::uint64_t postponed_ns_ = 0;  ///< Time until lower overrides are tried again.
  /// Value of BlockQueue::plans() for the plan that the present phase follows.
  std::uint32_t followed_ = 0;
  bool replan_ = false;

  // The block in which the plan is or, between two blocks, the next block.
  std::size_t index_ = 0;      ///< Index of the block in the queue.
  bool driving_ = false;       ///< True if the plan has begun the block.
  PathUnits length_ = 0;       ///< Length of the block.
  PathUnits place_ = 0;        ///< Position within the block.
  float speed_ = 0.0F;         ///< Speed of the plan, mm/s.
  float entry_square_ = 0.0F;  ///< v² at the start of the next block.

  // The present phase of the block.
  Drive phase_drive_ = Drive::kOn;
  Phase phase_{};
  PathUnits phase_from_ = 0;
  PhaseCourse course_{};
  std::uint64_t elapsed_ns_ = 0;  ///< Time since the start of the phase.
  PhaseClock clock_{};
  PathUnits lead_ = 0;  ///< Distance by which the stretches returned so far reach beyond place_.

  // State from which patience() is computed.
  std::uint32_t since_speeding_up_ns_ = kLongAgo;
  std::uint32_t since_braking_ns_ = kLongAgo;
  float braking_from_ = 0.0F;  ///< Speed of the plan when it last did not brake, mm/s.
  bool overtaken_ = false;
};

}  // namespace cnc::motion
