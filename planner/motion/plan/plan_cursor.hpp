#pragma once

#include <cstddef>

#include "planner/motion/lookahead/block_queue.hpp"
#include "planner/motion/plan/phase_clock.hpp"
#include "planner/motion/plan/phase_course.hpp"
#include "planner/motion/plan/speed_profile.hpp"

namespace cnc::motion {

/// Drives the plan through the blocks of a queue as time goes on: the place and
/// speed that the limits of speed and acceleration allow.
///
/// Blocks are taken from the queue by whoever drives the motors, which may be
/// later; block_left() tells that one has gone. A change of plan, override or
/// hold takes effect with the next stretch.
///
/// Main loop only.
class PlanCursor {
 public:
  PlanCursor(BlockQueue& queue, const Limits& limits) : queue_{queue}, limits_{limits} {}

  /// The next stretch, at most `most_ns` long, within one block and phase; of no
  /// duration when the plan stands still: everything planned, or halted, or it stands
  /// and may not start yet.
  [[nodiscard]] Stretch next(std::uint32_t most_ns, Drive drive, bool may_start);

  /// Under a window a lower pace holds at once, a higher one as soon as the place
  /// and the speed are such that its plan can be taken up.
  void set_overrides(const Overrides& overrides);
  /// As asked for.
  [[nodiscard]] const Overrides& overrides() const { return overrides_; }

  /// The motion is the mean of the plan over so long from now on. @pre at rest
  void set_window(const TimeWindow& window);
  /// The window that suits the way to the next stop; the longest where it is not known. It
  /// stays so: nothing that comes later joins that way.
  /// @pre at rest, not at_end()
  [[nodiscard]] TimeWindow choose_window();

  /// The front of the queue is about to be taken away. @pre the plan has left it
  void block_left();
  /// Returns how many blocks at the front of the queue the plan has left: the next stretch is of
  /// the block behind them.
  [[nodiscard]] std::size_t blocks_left() const { return index_; }
  /// Forgets everything; the queue is empty.
  void reset();

  /// mm/s.
  [[nodiscard]] float speed() const { return speed_; }
  /// Nothing is left to plan.
  [[nodiscard]] bool at_end() const { return !driving_ && index_ == queue_.size(); }

 private:
  [[nodiscard]] std::size_t chain_end() const;
  [[nodiscard]] TimeWindow quickest(const WindowChoice& choice, std::size_t end);
  [[nodiscard]] std::uint64_t time_to(std::size_t end, const TimeWindow& window);
  [[nodiscard]] Patience patience() const;
  [[nodiscard]] Stretch follow(std::uint32_t most_ns, Drive drive, bool may_start);
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
  [[nodiscard]] Stretch pass(std::uint32_t most_ns);
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
  SpeedProfile profile_{};  ///< Of the block that is being planned through.
  /// Overrides as last requested; the current plan may still use older ones.
  Overrides overrides_{};
  PlanTerms terms_{};
  std::uint64_t untried_ns_ = 0;    ///< Since a higher pace was last tried.
  std::uint64_t postponed_ns_ = 0;  ///< Until a lower pace is tried again.
  std::uint32_t followed_ = 0;      ///< The queue's plan that the present phase is of.
  bool replan_ = false;

  // The block.
  std::size_t index_ = 0;      ///< Of the block that is or will be planned through.
  bool driving_ = false;       ///< It has been begun.
  PathUnits length_ = 0;       ///< Of the block.
  PathUnits place_ = 0;        ///< Within the block.
  float speed_ = 0.0F;         ///< mm/s.
  float entry_square_ = 0.0F;  ///< v² with which the next block is begun.

  // Its present phase.
  Drive phase_drive_ = Drive::kOn;
  Phase phase_{};
  PathUnits phase_from_ = 0;
  PhaseCourse course_{};
  std::uint64_t elapsed_ns_ = 0;  ///< Of the course.
  PhaseClock clock_{};
  PathUnits lead_ = 0;  ///< Distance by which what was handed out is beyond the place.

  // What Patience is made of.
  std::uint32_t since_speeding_up_ns_ = kLongAgo;
  std::uint32_t since_braking_ns_ = kLongAgo;
  float braking_from_ = 0.0F;  ///< mm/s, the speed when the plan last did not brake.
  bool overtaken_ = false;
};

}  // namespace cnc::motion
