#pragma once

#include <cstdint>

#include "planner/kinematics/tool_centre.hpp"
#include "planner/motion/segment/filtered_plan.hpp"
#include "planner/motion/segment/joined_slices.hpp"
#include "planner/motion/segment/kerf_shift.hpp"
#include "planner/motion/segment/motor_path.hpp"
#include "planner/motion/segment/pixel_course.hpp"
#include "planner/motion/segment/planned_slice.hpp"
#include "planner/motion/segment/reversals.hpp"
#include "planner/motion/segment/segment.hpp"
#include "planner/motion/segment/segment_power.hpp"
#include "planner/motion/segment/segment_rate.hpp"
#include "planner/motion/segment/stretch_in_progress.hpp"

namespace cnc::motion {

/// A slice of the driven motion: constant acceleration along a part of one block.
struct Slice {
  std::uint32_t block = 0;  ///< Number of the block since the last reset, from 0.
  /// Fraction of the block's length at the start of the slice, in Q32; 2^32 is the end of the
  /// block.
  std::uint64_t from_fraction = 0;
  std::uint64_t to_fraction = 0;
  float start_speed = 0.0F;   ///< mm/s.
  float acceleration = 0.0F;  ///< mm/s².
  float duration = 0.0F;      ///< s.
};

/// Receives the slices of the plan, before they become pulses.
class SliceObserver {
 public:
  virtual void on_slice(const Slice& slice) = 0;

 protected:
  ~SliceObserver() = default;
};

/// Cuts the planned motion into segments for the step interrupt.
///
/// Removes each block from the front of a queue when the motors reach its end. Cuts the stretches
/// of the plan so that a slice is within one block and one pixel, lasts at most a millisecond and
/// reverses no axis. Added blocks, an override or a hold take effect at the next stretch.
///
/// A slice shorter than SegmentRate::kShortest is joined to one segment with the slices after it,
/// so that a full queue of segments lasts until the next segments are made. A segment is shorter
/// than kShortest only where an axis reverses, the power jumps, outputs change or the motion ends.
/// Where the power jumps so often that the queue would run empty, a segment has a level for each of
/// its slices. Where pixels are shorter than kShortest, one slice covers several pixels, and each
/// of these pixels has a level.
///
/// Main loop only. The state of the object is the state at the end of the last slice handed out.
class Segmenter {
 public:
  static constexpr float kLongestSlice = 1.0e-3F;  ///< s.

  /// @param pixels pixels of the rows of all blocks; null if no block has a row
  Segmenter(BlockQueue& queue, const Limits& limits, Pixels* pixels = nullptr)
      : queue_{queue}, limits_{limits}, plan_{queue, limits}, power_{pixels} {}

  /// Makes the next segment. Returns false if there is none: all blocks are driven, or the motion
  /// is halted.
  [[nodiscard]] bool next(Segment& segment);
  /// Makes the next slice, of at most `max_ns`, for a caller that makes the pulses itself. Returns
  /// false if there is none.
  [[nodiscard]] bool next(std::uint32_t max_ns, PlannedSlice& slice);

  void set_overrides(const Overrides& overrides) { plan_.set_overrides(overrides); }
  [[nodiscard]] const Overrides& overrides() const { return plan_.overrides(); }

  void halt() { plan_.halt(); }
  void go_on() { plan_.go_on(); }

  /// Returns whether no motion is left to hand out.
  [[nodiscard]] bool idle() const { return !driving_ && queue_.empty(); }
  /// Returns whether the motion is at rest. It may be halted within a block.
  [[nodiscard]] bool at_rest() const { return speed_ <= 0.0F; }
  /// Returns the position at the end of the last slice handed out.
  [[nodiscard]] const AxisArray<StepPosition>& place() const { return place_steps_; }
  /// Returns the distance from the present position to the end of the oldest block, in mm.
  /// @pre !idle()
  [[nodiscard]] float left_of_block() const {
    return driving_ ? to_mm(length_ - place_) : queue_.front().length;
  }
  /// Returns the distance of the present position from the start of the oldest block, in path
  /// units.
  /// @pre !idle()
  [[nodiscard]] PathUnits into_block() const { return driving_ ? place_ : 0; }
  /// Returns the running length of all motion that was handed out (wraps). Motion that was taken
  /// back no longer counts.
  [[nodiscard]] std::uint64_t travelled() const {
    return ended_ + static_cast<std::uint64_t>(place_);
  }
  /// Returns the speed at the end of the last slice handed out, in mm/s.
  [[nodiscard]] float speed() const { return speed_; }
  /// Returns the speed of the plan, in mm/s. Where jerk is limited, the plan is ahead of the motion
  /// that was handed out, because the motion is the mean of the plan over a time window.
  [[nodiscard]] float planned_speed() const { return plan_.planned_speed(); }
  [[nodiscard]] const TimeWindow& window() const { return plan_.window(); }
  [[nodiscard]] bool halted() const { return plan_.halts() && at_rest(); }

  /// Shifts the motors, on blocks next to an edge of the part, by half of the difference between
  /// the kerf at the driven power and speed and the programmed kerf. The ends of planned slices
  /// then include the shift for the kerf. Segments do not include it. Null ends the shifting.
  /// @param course must outlive its use
  /// @pre at rest, and on_path()
  void follow_kerf(const kerf::KerfCourse* course) { kerf_.follow(course); }
  [[nodiscard]] bool follows_kerf() const { return kerf_.follows(); }
  /// Returns whether the kerf does not shift the motors away from the path at present.
  [[nodiscard]] bool on_path() const { return kerf_.settled(); }

  /// Converts the ends of planned slices from positions of the tool's tip to positions of the axes.
  /// Segments are not converted.
  /// @param centre must outlive its use; null if rotary axes do not move the tip
  /// @pre at rest
  void follow_centre(const kinematics::ToolCentre* centre) { centre_ = centre; }
  /// Returns whether the ends of planned slices may differ from place().
  [[nodiscard]] bool leaves_path() const { return follows_kerf() || centre_ != nullptr; }

  /// Forgets all motion; the motors are at `place` now. A halt remains.
  void reset(const AxisArray<StepPosition>& place);
  /// Continues from rest at `place` on the block at the front of the queue, after blocks were taken
  /// back.
  /// @param distance length of the motion beyond `place` that was already handed out
  /// @pre at rest; 0 ≤ place < length of that block
  void go_back(PathUnits place, PathUnits distance);
  /// Returns the position of the motors after the last slice: place(), with the shift for the kerf
  /// and the correction for rotary axes.
  [[nodiscard]] AxisArray<StepPosition> motors() const;

  /// Reports every slice to `observer` from now on; null stops the reports.
  void observe(SliceObserver* observer) { observer_ = observer; }

 private:
  void stand(const AxisArray<StepPosition>& place);
  [[nodiscard]] bool ready_stretch();
  /// Duties of the output, 0…1, at the start and at the end of a slice.
  struct Duties {
    float start = 0.0F;
    float end = 0.0F;
  };
  /// A slice that was cut from the plan: its end, its duration and its output.
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
  /// The end of a slice: a time within the stretch and a position on the block.
  struct End {
    std::uint32_t ns = 0;
    PathUnits place = 0;
  };
  [[nodiscard]] End end_of_slice(PathUnits stop, std::uint32_t max_ns);
  [[nodiscard]] Cut cut_slice(std::uint32_t max_ns);
  [[nodiscard]] Cut cut(const End& end);
  void move_to(const MotorPath::Point& point);
  void pass_to_rest();
  void follow_kerf_to(PathUnits end, std::uint64_t fraction);
  [[nodiscard]] float heat() const;
  void make_segment(Segment& segment);
  void begin_joined();
  void join_next(std::uint32_t max_ns);
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
  FilteredPlan plan_;
  StretchInProgress stretch_{};

  bool driving_ = false;    ///< True if the front block has begun.
  PathUnits length_ = 0;    ///< Length of the front block.
  PathUnits place_ = 0;     ///< Position within the front block, in path units.
  float widest_mm_ = 0.0F;  ///< Greatest length of a slice that the block's turning allows, mm.
  BlockFraction fraction_{};
  Reversals reversals_{};
  PixelCourse power_;
  MotorPath path_{};
  AxisArray<StepPosition> place_steps_{};
  AxisArray<float> rates_{};  ///< Present rates of the moving axes, steps per mm of path.
  float speed_ = 0.0F;        ///< mm/s.
  KerfShift kerf_{};
  const kinematics::ToolCentre* centre_ = nullptr;

  // The segment being made.
  JoinedSlices joined_{};
  /// Position up to which no axis reverses on the block that began last.
  PathUnits monotonic_to_ = 0;
  SourceLine line_{};
  SegmentPower output_{};
  SegmentRate rate_{};

  SliceObserver* observer_ = nullptr;
  std::uint32_t blocks_ended_ = 0;
  std::uint64_t ended_ = 0;  ///< Total length of the blocks that ended, in path units.
  OutputChanges outputs_{};  ///< Output changes that are not handed out yet.
};

}  // namespace cnc::motion
