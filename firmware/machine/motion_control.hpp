#pragma once

#include "firmware/machine/place_trail.hpp"
#include "firmware/steps/step_drive.hpp"
#include "planner/base/units.hpp"
#include "planner/pipeline/pipeline.hpp"

namespace cnc {

/// Moves the motors: passes the segments of the Pipeline to the StepDrive. Also computes the
/// position of the tool. Main loop only.
class MotionControl : private Pipeline {
 public:
  /// The other parameters are those of Pipeline.
  /// @param drive must outlive this object
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

  /// Returns whether append() may be called in this cycle. Returns false while the drive requires
  /// the main loop to catch up. Not inlined, because it is called at many points.
  [[nodiscard, gnu::noinline]] bool has_room() const;

  /// Hands segments to the drive until it has enough of them. To be called after attend(); the
  /// caller then settles the drive.
  void feed_drive();

  /// Returns whether nothing is planned, queued or moving.
  [[nodiscard]] bool drained() const { return empty() && !drive_.running(); }
  /// Returns whether halt() has stopped the motors and the remaining motion waits.
  [[nodiscard]] bool halted() const { return held() && !drive_.running(); }
  /// Returns whether nothing moves. Held motion may wait.
  [[nodiscard]] bool at_rest() const { return (empty() || held()) && !drive_.running(); }
  /// Drops all waiting motion. The position of the tool becomes the target.
  /// @pre the drive is not running
  void drop_rest();

  // The driven path, for LightGap.

  /// If `keeps`, begins to store the driven path, and the distance along it at recent ticks
  /// (PlaceTrail); otherwise ends this.
  void keep_path(bool keeps) {
    Pipeline::keep_path(keeps);
    trail_.hold(keeps);
  }
  /// Returns the distance driven since `tick`, a tick of the drive's clock. `tick` must be before
  /// the call of keep_path(true) or shortly after it.
  [[nodiscard]] motion::PathUnits distance_since(std::uint32_t tick) const {
    return trail_.distance_since(tick, travelled());
  }
  [[nodiscard]] bool is_lit_after(std::uint32_t tick) const { return trail_.is_lit_after(tick); }
  /// Sets the plan back by `distance` along the stored path. Returns the length of the part along
  /// which this is impossible. The motors must be moved to place() before the motion continues.
  /// @pre drained() or halted()
  motion::PathUnits go_back(motion::PathUnits distance);

  /// Sets input shaping and backlash. Has no effect if they are unchanged.
  /// @pre nothing moves, or they are unchanged
  void configure(const motion::MotorStageSetting& setting);
  /// Ends the correction of the path for the kerf if nothing is planned and the motors rest on the
  /// programmed path. To be called while no compensation is active.
  void stay_on_path() {
    if (follows_kerf() && on_path() && drained()) follow_kerf(nullptr);
  }

  /// Sets the tool centre by which the axes move from now on. If it is active, the tip follows the
  /// path while rotary axes turn.
  /// @pre drained()
  void set_tool_centre(const kinematics::ToolCentre& centre);

  /// Returns the tool's position in motor steps without backlash. Under G43.4 it is the position of
  /// the tip.
  [[nodiscard]] AxisArray<std::int32_t> tool_steps() const;
  /// Returns the tool's position in nanometres.
  [[nodiscard]] Position tool_place() const;
  /// Returns the tool's position on an axis, in steps, for a motor count that the step interrupt
  /// latched at a contact.
  /// @pre the axis was moving at the contact
  [[nodiscard]] std::int32_t tool_at_contact(std::size_t axis, std::int32_t steps) const {
    return steps - motors().backlash(axis).offset();
  }
  /// Sets the tool's position on an axis. The caller must call drop_rest() afterwards.
  /// @pre nothing moves
  void set_tool(std::size_t axis, std::int32_t steps);

  /// Returns the number of blocks that wait. blocks_free() returns the number of blocks that can be
  /// added.
  [[nodiscard]] std::size_t blocks() const { return queue().size(); }
  [[nodiscard]] std::size_t blocks_free() const {
    return blocks() < queue().capacity() ? queue().capacity() - blocks() : 0;
  }
  /// Returns the N word of the oldest element that is not driven to its end; 0 if there is none.
  [[nodiscard]] std::uint32_t line_in_execution() const { return line().number; }
  /// Returns the speed of the last planned segments, in mm/s; 0 at rest. The motors reach it within
  /// 20 ms.
  [[nodiscard]] float speed() const { return drive_.running() ? Pipeline::speed() : 0.0F; }
  [[nodiscard]] float speed_mm_min() const { return kSecondsPerMinute * speed(); }

 private:
  [[nodiscard]] AxisArray<std::int32_t> axis_steps() const;
  void follow_tool();
  void note_place();

  StepDrive& drive_;
  PlaceTrail trail_{};
  bool lit_ = false;  ///< Whether the beam is on in the last segment that was handed over.
  /// Position of the axes at the last follow_tool(), in steps without backlash.
  AxisArray<std::int32_t> axes_{};
};

}  // namespace cnc
