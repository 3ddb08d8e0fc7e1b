#pragma once

#include <cstddef>

#include "planner/motion/lookahead/block_queue.hpp"
#include "planner/motion/plan/phase_clock.hpp"
#include "planner/motion/plan/phase_course.hpp"
#include "planner/motion/plan/speed_profile.hpp"

namespace cnc::motion {

/// Drives the plan through the blocks of a queue as time goes on. The plan is the position and the
/// speed that the limits of speed and acceleration allow.
///
/// The object that drives the motors removes blocks from the queue, maybe later; it calls
/// block_left() for each. A change of the plan, an override or a hold takes effect with the next
/// stretch.
///
/// Main loop only.
class PlanCursor {
 public:
  PlanCursor(BlockQueue& queue, const Limits& limits) : queue_{queue}, limits_{limits} {}

  /// Returns the next stretch, at most `max_ns` long, within one block and phase. It has no
  /// duration when the plan is at rest: everything is planned, or the plan is halted, or it may not
  /// start yet.
  [[nodiscard]] Stretch next(std::uint32_t max_ns, Drive drive, bool may_start);

  /// Sets the overrides. Under a window, a lower pace holds at once. A higher one holds as soon as
  /// position and speed allow a change to its plan.
  void set_overrides(const Overrides& overrides);
  /// Returns the overrides as last requested.
  [[nodiscard]] const Overrides& overrides() const { return overrides_; }

  /// Sets the window over which the motion is the mean of the plan from now on. @pre at rest
  void set_window(const TimeWindow& window);
  /// Returns the window that suits the path to the next stop, or the longest window if that stop is
  /// not known. The choice is final: blocks that come later do not join this path.
  /// @pre at rest, not at_end()
  [[nodiscard]] TimeWindow choose_window();

  /// Prepares for the removal of the block at the front of the queue. @pre the plan has left it
  void block_left();
  /// Returns the number of blocks at the front of the queue that the plan has left. The next
  /// stretch lies in the block after them.
  [[nodiscard]] std::size_t blocks_left() const { return index_; }
  /// Forgets all of the plan; index 0 of the queue is the next block.
  void reset();

  /// Returns the speed of the plan, in mm/s.
  [[nodiscard]] float speed() const { return speed_; }
  /// Returns whether nothing is left to plan.
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
  SpeedProfile profile_{};  ///< Profile of the block that is being planned through.
  /// Overrides as last requested; the current plan may still use older ones.
  Overrides overrides_{};
  PlanTerms terms_{};
  std::uint64_t untried_ns_ = 0;    ///< Time since a higher pace was last tried.
  std::uint64_t postponed_ns_ = 0;  ///< Time until a lower pace is tried again.
  std::uint32_t followed_ = 0;      ///< Number of the queue's plan that the present phase follows.
  bool replan_ = false;

  // The block that is or will be planned through.
  std::size_t index_ = 0;      ///< Index of the block in the queue.
  bool driving_ = false;       ///< The block has been begun.
  PathUnits length_ = 0;       ///< Length of the block.
  PathUnits place_ = 0;        ///< Position within the block.
  float speed_ = 0.0F;         ///< mm/s.
  float entry_square_ = 0.0F;  ///< v² with which the next block is begun.

  // The present phase of the block.
  Drive phase_drive_ = Drive::kOn;
  Phase phase_{};
  PathUnits phase_from_ = 0;
  PhaseCourse course_{};
  std::uint64_t elapsed_ns_ = 0;  ///< Time since the start of the course.
  PhaseClock clock_{};
  PathUnits lead_ = 0;  ///< Distance by which the motion handed out is beyond place_.

  // Values for patience().
  std::uint32_t since_speeding_up_ns_ = kLongAgo;
  std::uint32_t since_braking_ns_ = kLongAgo;
  float braking_from_ = 0.0F;  ///< Speed when the plan last did not brake, mm/s.
  bool overtaken_ = false;
};

}  // namespace cnc::motion
