#pragma once

#include <cstdint>

#include "planner/kinematics/tool_centre.hpp"
#include "planner/motion/jerk/motion_filter.hpp"
#include "planner/motion/plan/plan_cursor.hpp"
#include "planner/motion/segment/joined_slices.hpp"
#include "planner/motion/segment/kerf_shift.hpp"
#include "planner/motion/segment/motor_path.hpp"
#include "planner/motion/segment/pixel_course.hpp"
#include "planner/motion/segment/planned_slice.hpp"
#include "planner/motion/segment/reversals.hpp"
#include "planner/motion/segment/segment.hpp"
#include "planner/motion/segment/segment_power.hpp"
#include "planner/motion/segment/segment_rate.hpp"

namespace cnc::motion {

/// A slice of the plan as driven: constant acceleration along one block.
struct Slice {
  std::uint32_t block = 0;          ///< Counted from 0 since the last reset.
  std::uint64_t from_fraction = 0;  ///< Of the block's length; 2^32 is its end.
  std::uint64_t to_fraction = 0;
  float start_speed = 0.0F;   ///< mm/s.
  float acceleration = 0.0F;  ///< mm/s².
  float duration = 0.0F;      ///< s.
};

/// Whoever wants to see the plan itself rather than its pulses.
class SliceObserver {
 public:
  virtual void on_slice(const Slice& slice) = 0;

 protected:
  ~SliceObserver() = default;
};

/// Cuts the planned motion into segments for the step interrupt.
///
/// Takes the blocks from the front of a queue as the motors come to their ends,
/// and slices the stretches of the plan so that a slice lies in one block and one
/// pixel, lasts at most a millisecond and reverses no axis. A change of plan, override or
/// hold takes effect at the next stretch.
///
/// Slices shorter than SegmentRate::kShortest go out as one segment with those after them, so that
/// a queue of segments lasts. Only where an axis turns round, the power jumps, outputs change or
/// the motion ends is a segment shorter; where the power jumps so often that the queue would not
/// last, a segment has a level for each of its slices. A slice goes on over pixels that are shorter
/// than that, each of which has a level, too.
///
/// Main loop only. All state is where the last slice handed out has ended.
class Segmenter {
 public:
  static constexpr float kLongestSlice = 1.0e-3F;  ///< s.

  /// @param pixels of the blocks' rows; null where no block has any
  Segmenter(BlockQueue& queue, const Limits& limits, Pixels* pixels = nullptr)
      : queue_{queue}, limits_{limits}, plan_{queue, limits}, power_{pixels} {}

  /// The next slice; false when there is none: everything driven, or halted.
  [[nodiscard]] bool next(Segment& segment);
  /// The same slice, at most `most_ns` long, for whoever makes the pulses.
  [[nodiscard]] bool next(std::uint32_t most_ns, PlannedSlice& slice);

  void set_overrides(const Overrides& overrides) { plan_.set_overrides(overrides); }
  [[nodiscard]] const Overrides& overrides() const { return plan_.overrides(); }

  void halt() { drive_ = Drive::kHalt; }
  void go_on() { drive_ = Drive::kOn; }

  /// Nothing left to hand out.
  [[nodiscard]] bool idle() const { return !driving_ && queue_.empty(); }
  /// Standing still; while driving_ this means halted within a block.
  [[nodiscard]] bool at_rest() const { return speed_ <= 0.0F; }
  /// Where the last slice handed out ends.
  [[nodiscard]] const AxisArray<StepPosition>& place() const { return place_steps_; }
  /// mm to the end of the oldest block. @pre !idle()
  [[nodiscard]] float left_of_block() const {
    return driving_ ? to_mm(length_ - place_) : queue_.front().length;
  }
  /// Distance from the start of the oldest block. @pre !idle()
  [[nodiscard]] PathUnits into_block() const { return driving_ ? place_ : 0; }
  /// Running length of all that was handed out (wraps); what is taken back counts no longer.
  [[nodiscard]] std::uint64_t travelled() const {
    return ended_ + static_cast<std::uint64_t>(place_);
  }
  /// mm/s at the end of the last slice handed out.
  [[nodiscard]] float speed() const { return speed_; }
  /// mm/s of the plan, which is ahead of what was handed out where jerk is limited:
  /// the motion is its mean over the window.
  [[nodiscard]] float planned_speed() const { return plan_.speed(); }
  [[nodiscard]] const TimeWindow& window() const { return window_; }
  [[nodiscard]] bool halted() const { return drive_ == Drive::kHalt && at_rest(); }

  /// Beside edges the motors follow the kerf of the power and speed that are driven: slices end
  /// off the path by so much. Segments do not. Null: not any more.
  /// @param course outlives its use @pre at rest, and on the path
  void follow_kerf(const kerf::KerfCourse* course) { kerf_.follow(course); }
  [[nodiscard]] bool follows_kerf() const { return kerf_.follows(); }
  /// The motors are where place() says, but for a tool's centre.
  [[nodiscard]] bool on_path() const { return kerf_.settled(); }

  /// Lets slices end where the axes have to be so that the tip is at place(). Segments do not.
  /// @param centre outlives its use; null where rotary axes do not move the tip @pre at rest
  void follow_centre(const kinematics::ToolCentre* centre) { centre_ = centre; }
  /// Returns whether slices end elsewhere than at place().
  [[nodiscard]] bool leaves_path() const { return follows_kerf() || centre_ != nullptr; }

  /// Forgets all motion; the motors stand at `place` now. A halt stays.
  void reset(const AxisArray<StepPosition>& place);
  /// Goes on from rest at `place` on the block at the front of the queue, to which blocks were
  /// taken back. @param distance that was handed out beyond it @pre at rest; 0 ≤ place < its length
  void go_back(PathUnits place, PathUnits distance);
  /// Returns where the motors stand after the last slice: place(), with what follows the kerf and
  /// what rotary axes ask for.
  [[nodiscard]] AxisArray<StepPosition> motors() const;

  /// Tells `observer` of every slice from now on; null for nobody.
  void observe(SliceObserver* observer) { observer_ = observer; }

 private:
  void stand(const AxisArray<StepPosition>& place);
  [[nodiscard]] bool ready_stretch();
  [[nodiscard]] Stretch next_stretch();
  void choose_window();
  [[nodiscard]] bool fill_cell();
  /// Of the output, 0…1, at the start and at the end of a slice.
  struct Duties {
    float start = 0.0F;
    float end = 0.0F;
  };
  /// What a slice was.
  struct Cut {
    MotorPath::Point to{};
    std::uint32_t duration_ns = 0;
    float start_speed = 0.0F;  ///< mm/s.
    Duties duty{};
  };

  [[nodiscard]] bool ready_block();
  void begin_block();
  void end_block();
  [[nodiscard]] std::uint32_t longest_slice_ns() const;
  /// Where a slice ends: a time of the stretch and a place of the block.
  struct End {
    std::uint32_t ns = 0;
    PathUnits place = 0;
  };
  [[nodiscard]] End end_of_slice(PathUnits stop, std::uint32_t most_ns);
  [[nodiscard]] Cut cut_slice(std::uint32_t most_ns);
  [[nodiscard]] Cut cut(const End& end);
  void move_to(const MotorPath::Point& point);
  void pass_to_rest();
  void follow_kerf_to(PathUnits end, std::uint64_t fraction);
  [[nodiscard]] float heat() const;
  void make_segment(Segment& segment);
  void begin_joined();
  void join_next(std::uint32_t most_ns);
  [[nodiscard]] bool pixels_are_short();
  void add_pixels(const End& end);
  void join(const Cut& cut);
  [[nodiscard]] bool joins_next();
  [[nodiscard]] bool goes_on_as_joined();
  [[nodiscard]] bool power_follows_speed() const;
  [[nodiscard]] float duty_at(float speed) const;
  [[nodiscard]] Duties duties(float start_speed, float end_speed) const;

  BlockQueue& queue_;
  const Limits& limits_;
  PlanCursor plan_;
  TimeWindow window_{};
  MotionFilter filter_{};  ///< Of the plan, under a window.
  Drive drive_ = Drive::kOn;

  PhaseCourse course_{};          ///< Of the stretch being cut.
  PathUnits stretch_from_ = 0;    ///< Like place_; below 0 when it began in an earlier block.
  std::uint32_t elapsed_ns_ = 0;  ///< Of the stretch.

  bool driving_ = false;    ///< The front block has been begun.
  PathUnits length_ = 0;    ///< Of the front block.
  PathUnits place_ = 0;     ///< Within it.
  float widest_mm_ = 0.0F;  ///< As long as a slice may be for its turning.
  BlockFraction fraction_{};
  Reversals reversals_{};
  PixelCourse power_;
  MotorPath path_{};
  AxisArray<StepPosition> place_steps_{};
  AxisArray<float> rates_{};  ///< Steps per mm of path, of the axes that move.
  float speed_ = 0.0F;        ///< mm/s.
  KerfShift kerf_{};
  const kinematics::ToolCentre* centre_ = nullptr;

  // Of the segment being made.
  JoinedSlices joined_{};
  PathUnits monotonic_to_ = 0;  ///< On the block begun last: no axis turns round before.
  SourceLine line_{};
  SegmentPower output_{};
  SegmentRate rate_{};

  SliceObserver* observer_ = nullptr;
  std::uint32_t blocks_ended_ = 0;
  std::uint64_t ended_ = 0;  ///< Length of the blocks that ended.
  OutputChanges outputs_{};  ///< Not handed out yet.
};

}  // namespace cnc::motion
