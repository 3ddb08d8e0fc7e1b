#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/base/coordinate.hpp"
#include "planner/motion/block/block_builder.hpp"
#include "planner/motion/lookahead/block_queue.hpp"
#include "planner/motion/motors/motor_segments.hpp"
#include "planner/path/path_stage.hpp"
#include "planner/pipeline/supply_watch.hpp"
#include "planner/pipeline/work_budget.hpp"

namespace cnc {

/// The planner as one object: it takes path elements and returns segments for a step generator.
///
/// It connects the stages: the path that is driven (welds, corners), blocks, look-ahead, plan,
/// segments, input shaping and backlash. The caller appends elements while has_room(), calls
/// attend() once in each cycle of its main loop, and takes segments with next() whenever its step
/// generator needs them. ActionElements computes the elements of a line of G-code.
///
/// It uses no clock, drive or port: time passes only in attend() and next(). Main loop only; no
/// call blocks or allocates, and the work of each call is bounded.
class Pipeline {
 public:
  /// Creates an empty pipeline.
  /// @param limits limits of the machine; must outlive this, and may change only while empty()
  /// @param pixels storage of the rows' powers, which a chip may keep in separate memory; must
  ///     outlive this
  Pipeline(const motion::Limits& limits, motion::Pixels& pixels)
      : limits_{limits},
        pixels_{pixels},
        path_{limits, &pixels},
        segmenter_{queue_, limits, &pixels} {}

  // Input of elements.

  /// Returns whether append() may be called in this cycle. The planning work of a cycle is bounded,
  /// so the result may change to true with the next attend().
  [[nodiscard]] bool has_room() const {
    return path_.has_room() && budget_.allows_element(queue_.looked_at());
  }
  /// Appends an element that starts at target(). The last elements are held back until later
  /// elements are known, or until flush() is called.
  /// @return false for an element that does not move, or an error if its end is out of the motors'
  ///     range. After an error nothing has changed.
  /// @pre has_room()
  Result<bool, motion::MotionError> append(const path::PathItem& item);
  /// Returns whether append_row() may be called in this cycle for a row of `pixels` pixels. If not,
  /// this may change with the next attend(). Also passes held elements on as far as possible.
  [[nodiscard]] bool takes_row(std::size_t pixels);
  /// Appends a line that is a complete row of pixels. `powers` need not outlive the call.
  /// @return false for a line that does not move, or an error if its end is out of the motors'
  ///     range. After an error nothing has changed.
  /// @pre has_room(), takes_row(), path::PixelRow::can_be_row()
  Result<bool, motion::MotionError> append_row(const path::PathItem& item,
                                               const path::RowPowers& powers);
  /// Releases the held elements, because no element follows before the motion has ended. Call this
  /// in each cycle until empty() returns true.
  void flush();
  /// Adds up the elapsed time, plans, and releases held elements before the motion would have to
  /// brake for lack of them. Call this once in each cycle.
  /// @param elapsed_us time since the last call
  void attend(std::int32_t elapsed_us);
  /// Returns the end of all elements that were appended, machine coordinates.
  [[nodiscard]] const Position& target() const { return target_; }

  // Output of segments.

  /// Makes the next segment, of at most a millisecond.
  /// @return false if there is no segment, because the motion is held, no block is left until the
  ///     next attend(), or the motor stage drives another motion
  [[nodiscard]] bool next(motion::Segment& segment) {
    return motion::next_segment(segmenter_, motors_, segment);
  }
  /// Returns whether all elements have been given out as segments.
  [[nodiscard]] bool empty() const {
    return path_.empty() && segmenter_.idle() && motors_.at_rest();
  }
  /// Returns whether halt() has taken effect: the motion has come to rest at the end of the last
  /// segment.
  [[nodiscard]] bool held() const { return segmenter_.halted() && motors_.at_rest(); }

  // Actions of the operator.

  /// Decelerates within the limits and holds the rest of the motion.
  void halt() { segmenter_.halt(); }
  /// Ends a halt, so that the held motion continues.
  void go_on() { segmenter_.go_on(); }
  /// If `keeps`, stores the path of all segments from now on, and of earlier segments as far as it
  /// is known, so that go_back() can return along it. Otherwise stops storing the path. While
  /// the path is stored, has_room() may become false and stay false.
  void keep_path(bool keeps) { queue_.keep_all(keeps); }
  /// Takes back the last `distance` of the path that was given out as segments. place() moves back
  /// by that distance. Once the motors have been brought to motor_place(), next() continues from
  /// there, from rest.
  /// @return length of the part of `distance` that is no longer stored and was not taken back
  /// @pre held() or empty()
  motion::PathUnits go_back(motion::PathUnits distance);
  void set_overrides(const motion::Overrides& overrides) { segmenter_.set_overrides(overrides); }
  [[nodiscard]] const motion::Overrides& overrides() const { return segmenter_.overrides(); }

  // These functions may be called only while the machine is at rest.

  /// Drops all remaining motion. A halt stays in effect.
  /// @param tool position of the axes, in motor steps without backlash. The new target() is the
  ///     resulting position of the tip.
  /// @param motors position of the motors, steps
  /// @pre no segment that was taken is still being driven
  void restart(const AxisArray<std::int32_t>& tool, const AxisArray<std::int32_t>& motors);
  /// Sets input shaping and backlash. Afterwards the motors' position equals the tool position.
  /// @return false if nothing has changed
  /// @pre empty() or held(), or the setting is already in effect
  bool configure(const motion::MotorStageSetting& setting);
  /// Returns the stage between plan and motors. Another motion may use it while the planned motion
  /// is held.
  [[nodiscard]] motion::MotorStage& motors() { return motors_; }
  [[nodiscard]] const motion::MotorStage& motors() const { return motors_; }
  /// Lets the motors follow the kerf at the driven power and speed, as an offset from the path.
  /// @param course must outlive its use; null ends the offset
  /// @pre empty(), and on_path()
  void follow_kerf(const kerf::KerfCourse* course);
  [[nodiscard]] bool follows_kerf() const { return segmenter_.follows_kerf(); }
  /// Sets how the axes move, so that from now on the tip follows the path while rotary axes turn.
  /// The caller must then call restart(). @pre no segment that was taken is still being driven
  void set_tool_centre(const kinematics::ToolCentre& centre);
  [[nodiscard]] const kinematics::ToolCentre& tool_centre() const { return centre_; }
  /// Returns whether the motors are driven to positions other than place(): offset from the path,
  /// or corrected so that rotary axes do not move the tip.
  [[nodiscard]] bool leaves_path() const { return segmenter_.leaves_path(); }
  /// Returns whether the motors are at place(), without an offset by a kerf course.
  [[nodiscard]] bool on_path() const { return segmenter_.on_path(); }

  // Reports.

  /// Returns the position at the end of the last segment, to the fraction of a step.
  [[nodiscard]] const AxisArray<StepPosition>& place() const { return segmenter_.place(); }
  /// Returns the position of the motors after the last segment: place(), plus the offset by a kerf
  /// course and the correction for rotary axes.
  [[nodiscard]] AxisArray<StepPosition> motor_place() const { return segmenter_.motors(); }
  /// Returns the running length of the path of all segments so far (wraps). If
  /// motors().between_cells(), the motors reach the end of that path motors().ticks_ahead() ticks
  /// after the last segment.
  [[nodiscard]] std::uint64_t travelled() const { return segmenter_.travelled(); }
  /// Returns a position in steps. @pre `place` is within the motors' range
  [[nodiscard]] AxisArray<StepPosition> steps_of(const Position& place) const;
  /// Returns the machine coordinates of motor positions in steps.
  [[nodiscard]] Position place_of(const AxisArray<std::int32_t>& steps) const;
  /// Returns the speed at the end of the last segment, mm/s.
  [[nodiscard]] float speed() const { return segmenter_.speed(); }
  /// Returns the source line of the oldest element that has not been given out completely; 0 if
  /// there is no such element.
  [[nodiscard]] motion::SourceLine line() const {
    return queue_.empty() ? path_.line() : motion::line_of(queue_.front(), pixels_);
  }
  /// Returns the blocks that wait to be cut into segments.
  [[nodiscard]] const motion::BlockQueue& queue() const { return queue_; }
  /// Returns the running count of all blocks so far.
  [[nodiscard]] std::uint32_t blocks_taken() const { return blocks_taken_; }
  /// Sets the observer of every slice of the plan from now on; null removes it. @param observer
  /// must outlive this
  void observe(motion::SliceObserver* observer) { segmenter_.observe(observer); }

 private:
  [[nodiscard]] Result<bool, motion::MotionError> admit(const PathElement& element) const;
  void pump();
  void take(const path::PathPiece& piece);
  void release_held();
  [[nodiscard]] bool can_take_back(const motion::Block& block);
  [[nodiscard]] bool runs_dry() const;

  const motion::Limits& limits_;
  motion::Pixels& pixels_;
  path::PathStage path_;
  motion::BlockQueueOf<motion::kLookAheadBlocks, motion::kBlocksKept> queue_{};
  motion::Segmenter segmenter_;
  motion::MotorStage motors_{};
  motion::MotorStageSetting motor_setting_{};
  kinematics::ToolCentre centre_{};
  Position target_{};
  SupplyWatch supply_{};
  WorkBudget budget_{};
  std::uint32_t blocks_taken_ = 0;
};

}  // namespace cnc
