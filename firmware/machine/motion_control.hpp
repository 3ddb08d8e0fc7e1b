#pragma once

#include "firmware/steps/step_drive.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/motion/block_builder.hpp"
#include "planner/motion/block_queue.hpp"
#include "planner/motion/motor_stage.hpp"
#include "planner/motion/segmenter.hpp"
#include "planner/path/path_stage.hpp"

namespace cnc {

/// From path elements to the step drive: the path that is driven, the blocks, the
/// plan, the segments, and where the motors are to be. Main loop only.
class MotionControl {
 public:
  MotionControl(StepDrive& drive, const motion::Limits& limits)
      : drive_{drive},
        limits_{limits},
        stage_{limits, &pixels_},
        segmenter_{queue_, limits, &pixels_} {}

  /// For another element, and for planning it in this turn: what a turn takes is bounded, so that
  /// the processor is done with it in time.
  [[nodiscard]] bool has_room() const { return stage_.has_room() && work_owed() < kSpansInATurn; }

  /// Appends the way from the target so far to `end`. Nothing to move counts
  /// as done. The last elements are held back until the next ones are known, or
  /// flush(). @pre has_room()
  Result<bool, motion::MotionError> append(const path::PathItem& item);
  /// Nothing comes after what was appended: jogs, searches, and whoever waits
  /// for drained().
  void flush();
  /// Gives out what is held back before the machine would have to brake for it.
  /// Once in each turn.
  void attend(std::int32_t elapsed_us);

  /// Where the motion taken so far will end.
  [[nodiscard]] const Position& target() const { return target_; }

  /// Hands segments to the drive until it has enough; the caller wakes it then.
  /// Call at least every few ms.
  void feed_drive();

  /// Nothing planned, nothing queued, nothing moving.
  [[nodiscard]] bool drained() const {
    return stage_.empty() && segmenter_.idle() && motors_.at_rest() && !drive_.running();
  }
  /// Stopped by halt(), with the rest of the motion waiting.
  [[nodiscard]] bool halted() const {
    return segmenter_.halted() && motors_.at_rest() && !drive_.running();
  }

  void halt() { segmenter_.halt(); }
  void go_on() { segmenter_.go_on(); }
  void set_overrides(const motion::Overrides& overrides) { segmenter_.set_overrides(overrides); }
  [[nodiscard]] const motion::Overrides& overrides() const { return segmenter_.overrides(); }

  /// Drops all motion that waits; the target becomes where the tool is.
  /// @pre the drive is not running
  void drop_rest();

  /// Input shaping and backlash. Nothing happens where they stay as they are.
  /// @pre nothing moves, or they stay
  void configure(const motion::MotorStageSetting& setting);
  /// Between plan and motors, for whoever moves them while this motion is held.
  [[nodiscard]] motion::MotorStage& motors() { return motors_; }

  [[nodiscard]] Position place_of(const AxisArray<std::int32_t>& steps) const;
  /// Where the tool is, in motor steps without backlash.
  [[nodiscard]] AxisArray<std::int32_t> tool_steps() const;
  /// Where it was when its axis was on its way and the motor's counter said `steps`:
  /// a contact that the step interrupt latched.
  [[nodiscard]] std::int32_t tool_at_contact(std::size_t axis, std::int32_t steps) const {
    return steps - motors_.backlash(axis).offset();
  }
  /// Says where the tool is. drop_rest() follows. @pre nothing moves
  void set_tool(std::size_t axis, std::int32_t steps);
  /// Where the segments planned so far end, to the fraction of a step.
  [[nodiscard]] const AxisArray<StepPosition>& place() const { return segmenter_.place(); }
  [[nodiscard]] std::size_t blocks_free() const { return queue_.capacity() - queue_.size(); }
  /// N of the oldest block that is not driven to its end; 0 for none.
  [[nodiscard]] std::uint32_t line_in_execution() const {
    return (queue_.empty() ? stage_.line() : motion::line_of(queue_.front(), pixels_)).number;
  }
  /// mm/s, of the segments cut last: what the motors do in at most 20 ms.
  [[nodiscard]] float speed() const { return drive_.running() ? segmenter_.speed() : 0.0F; }
  /// Beside edges the motors follow the kerf of the power and speed that are driven; null: not any
  /// more. @param course outlives its use @pre drained(), and they are on the path
  void follow_kerf(const kerf::KerfCourse* course);
  [[nodiscard]] bool follows_kerf() const { return segmenter_.follows_kerf(); }
  /// Nothing is beside any edge: as soon as the motors are on the path and at rest, they stay.
  void stay_on_path() {
    if (follows_kerf() && segmenter_.on_path() && drained()) follow_kerf(nullptr);
  }
  [[nodiscard]] std::size_t blocks() const { return queue_.size(); }
  [[nodiscard]] std::uint32_t blocks_taken() const { return blocks_taken_; }
  void observe(motion::SliceObserver* observer) { segmenter_.observe(observer); }

 private:
  /// To read an element takes the emulated chip as long as planning takes to look at so many spans
  /// of blocks: a tenth of a turn.
  static constexpr std::uint32_t kSpansForElement = 24;
  /// 8 elements, or some of them and planning. A plan over all that waits takes longer, and is
  /// paid for by turns in which no element is taken.
  static constexpr std::uint32_t kSpansInATurn = 8 * kSpansForElement;

  /// In spans, that the turns so far have done and not paid for.
  [[nodiscard]] std::uint32_t work_owed() const {
    return queue_.looked_at() + kSpansForElement * elements_taken_ - paid_for_;
  }
  void pump();
  void take(const path::PathPiece& piece);
  [[nodiscard]] bool joins(const Position& start) const;
  void follow_tool();
  [[nodiscard]] bool runs_dry() const;

  StepDrive& drive_;
  const motion::Limits& limits_;
  motion::Pixels pixels_{};
  path::PathStage stage_;
  motion::BlockQueueOf<motion::kLookAheadBlocks> queue_{};
  motion::Segmenter segmenter_;
  motion::MotorStage motors_{};
  motion::MotorStageSetting motor_setting_{};
  AxisArray<std::int32_t> tool_{};  ///< Where the play of its axes left the tool when last seen.
  Position target_{};
  std::int32_t silence_us_ = 0;       ///< Since the last element came.
  std::int32_t held_us_ = 0;          ///< Since the stage has been holding elements.
  std::uint32_t elements_taken_ = 0;  ///< Runs freely.
  std::uint32_t paid_for_ = 0;        ///< Of the work until now; runs freely.
  std::uint32_t blocks_taken_ = 0;
};

}  // namespace cnc
