#pragma once

#include <cstdint>

#include "planner/motion/jerk/motion_filter.hpp"
#include "planner/motion/plan/plan_cursor.hpp"

namespace cnc::motion {

/// The motion that the motors are to make. It is the plan itself or, where jerk is limited, the
/// mean of the plan over a time window.
///
/// Main loop only.
class FilteredPlan {
 public:
  FilteredPlan(BlockQueue& queue, const Limits& limits) : plan_{queue, limits} {}

  /// Returns the next stretch of the motion, at most `max_ns` long. Its duration is 0 if there is
  /// no motion: all blocks are driven, or the motion is halted.
  /// @pre max_ns is at least the duration of a cell of the filter, see MotionFilter
  [[nodiscard]] Stretch next(std::uint32_t max_ns);
  /// Forgets the plan and the window. The motors must be at rest. A halt stays in effect.
  void reset();

  void halt() { drive_ = Drive::kHalt; }
  void go_on() { drive_ = Drive::kOn; }
  /// Returns whether the motion stops, or has stopped, because of a halt.
  [[nodiscard]] bool halts() const { return drive_ == Drive::kHalt; }

  void set_overrides(const Overrides& overrides) { plan_.set_overrides(overrides); }
  [[nodiscard]] const Overrides& overrides() const { return plan_.overrides(); }
  /// Returns the speed of the plan, in mm/s. Under a time window, the plan is ahead of the motion.
  [[nodiscard]] float planned_speed() const { return plan_.speed(); }
  [[nodiscard]] const TimeWindow& window() const { return window_; }
  /// Prepares for the removal of the block at the front of the queue. @pre the motion has left this
  /// block
  void block_left() { plan_.block_left(); }

 private:
  void choose_window();
  [[nodiscard]] bool fill_cell();

  PlanCursor plan_;
  TimeWindow window_{};
  MotionFilter filter_{};  ///< Computes the motion from the plan under a time window.
  Drive drive_ = Drive::kOn;
};

}  // namespace cnc::motion
