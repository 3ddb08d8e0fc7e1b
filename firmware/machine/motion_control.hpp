#pragma once

#include "firmware/machine/place_trail.hpp"
#include "firmware/steps/step_drive.hpp"
#include "planner/pipeline/pipeline.hpp"

namespace cnc {

/// Drives the motion of a Pipeline with a StepDrive, and knows where the tool is. Main loop only.
class MotionControl : private Pipeline {
 public:
  /// As Pipeline has them. @param drive must outlive this
  MotionControl(StepDrive& drive, const motion::Limits& limits, motion::Pixels& pixels)
      : Pipeline{limits, pixels}, drive_{drive} {}

  using Pipeline::append;
  using Pipeline::append_row;
  using Pipeline::attend;
  using Pipeline::blocks_taken;
  using Pipeline::flush;
  using Pipeline::follow_kerf;
  using Pipeline::follows_kerf;
  using Pipeline::go_on;
  using Pipeline::halt;
  using Pipeline::motor_place;
  using Pipeline::motors;
  using Pipeline::observe;
  using Pipeline::overrides;
  using Pipeline::place;
  using Pipeline::place_of;
  using Pipeline::set_overrides;
  using Pipeline::takes_row;
  using Pipeline::target;
  using Pipeline::tool_centre;

  /// Returns whether append() may be called in this turn; false while the main loop catches up.
  /// Out of line, as it is asked at many places.
  [[nodiscard, gnu::noinline]] bool has_room() const;

  /// Hands segments to the drive until it has enough of them; the caller then settles it. Call it
  /// after attend().
  void feed_drive();

  /// Returns whether nothing is planned, queued or moving.
  [[nodiscard]] bool drained() const { return empty() && !drive_.running(); }
  /// Returns whether halt() has stopped the motors, with the rest of the motion waiting.
  [[nodiscard]] bool halted() const { return held() && !drive_.running(); }
  /// Drops all motion that waits; the target becomes the place of the tool.
  /// @pre the drive is not running
  void drop_rest();

  // The path that was driven dark, see LightGap.

  /// Keeps the path that is driven from now on, and where on it the motion is now; or no longer.
  void keep_path(bool keeps) {
    Pipeline::keep_path(keeps);
    trail_.hold(keeps);
  }
  /// Returns the distance that was driven since a tick of the drive's clock, which is shortly
  /// after keep_path() at the latest.
  [[nodiscard]] motion::PathUnits distance_since(std::uint32_t tick) const {
    return trail_.distance_since(tick, travelled());
  }
  [[nodiscard]] bool is_lit_after(std::uint32_t tick) const { return trail_.is_lit_after(tick); }
  /// As Pipeline's: takes the motion back by `distance`; it goes on once the motors have been
  /// brought to place().
  /// @pre drained() or halted()
  motion::PathUnits go_back(motion::PathUnits distance);

  /// Sets input shaping and backlash; nothing happens if they stay.
  /// @pre nothing moves, or they stay
  void configure(const motion::MotorStageSetting& setting);
  /// Ends following the kerf, which no edge needs any more, once the motors rest on the path.
  void stay_on_path() {
    if (follows_kerf() && on_path() && drained()) follow_kerf(nullptr);
  }

  /// Lets the axes move so that the tip follows the path while rotary axes turn, from now on.
  /// @pre drained()
  void set_tool_centre(const kinematics::ToolCentre& centre);

  /// Returns where the tool is, in motor steps without backlash: its tip, where rotary axes do not
  /// move that.
  [[nodiscard]] AxisArray<std::int32_t> tool_steps() const;
  /// Returns the same to the nanometre.
  [[nodiscard]] Position tool_place() const;
  /// Returns where the tool was when its axis was moving and the motor's counter said `steps`:
  /// a contact that the step interrupt latched.
  [[nodiscard]] std::int32_t tool_at_contact(std::size_t axis, std::int32_t steps) const {
    return steps - motors().backlash(axis).offset();
  }
  /// Sets where the tool is; drop_rest() follows. @pre nothing moves
  void set_tool(std::size_t axis, std::int32_t steps);

  /// Number of blocks that wait, and of those that could be added.
  [[nodiscard]] std::size_t blocks() const { return queue().size(); }
  [[nodiscard]] std::size_t blocks_free() const {
    return blocks() < queue().capacity() ? queue().capacity() - blocks() : 0;
  }
  /// Returns the N of the oldest element that is not driven to its end; 0 for none.
  [[nodiscard]] std::uint32_t line_in_execution() const { return line().number; }
  /// Returns the speed of the segments cut last, mm/s: the motors have it within 20 ms.
  [[nodiscard]] float speed() const { return drive_.running() ? Pipeline::speed() : 0.0F; }

 private:
  [[nodiscard]] AxisArray<std::int32_t> axis_steps() const;
  void follow_tool();
  void note_place();

  StepDrive& drive_;
  PlaceTrail trail_{};
  bool lit_ = false;                ///< The segment that was handed over last.
  AxisArray<std::int32_t> axes_{};  ///< Place of the axes, within the backlash, when last seen.
};

}  // namespace cnc
