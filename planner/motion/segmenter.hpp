#pragma once

#include <cstdint>

#include "planner/motion/block_queue.hpp"
#include "planner/motion/motor_path.hpp"
#include "planner/motion/phase_course.hpp"
#include "planner/motion/segment.hpp"
#include "planner/motion/speed_profile.hpp"

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
/// Takes blocks from the front of a queue, drives each through its phases of
/// constant acceleration, and slices these into at most a millisecond. A change
/// of plan, override or hold takes effect at the next slice.
///
/// Main loop only. All state is where the last slice handed out has ended.
class Segmenter {
 public:
  static constexpr float kLongestSlice = 1.0e-3F;  ///< s.

  Segmenter(BlockQueue& queue, const Limits& limits) : queue_{queue}, limits_{limits} {}

  /// The next slice; false when there is none: everything driven, or halted.
  [[nodiscard]] bool next(Segment& segment);

  void set_overrides(const Overrides& overrides);
  [[nodiscard]] const Overrides& overrides() const { return overrides_; }

  void halt() { drive_ = Drive::kHalt; }
  void go_on() { drive_ = Drive::kOn; }

  /// Nothing left to hand out.
  [[nodiscard]] bool idle() const { return !driving_ && queue_.empty(); }
  /// Standing still; while driving_ this means halted within a block.
  [[nodiscard]] bool at_rest() const { return speed_ <= 0.0F; }
  /// Where the last slice handed out ends.
  [[nodiscard]] const AxisArray<StepPosition>& place() const { return here_.place; }
  /// mm/s at the end of the last slice handed out.
  [[nodiscard]] float speed() const { return speed_; }
  [[nodiscard]] bool halted() const { return drive_ == Drive::kHalt && at_rest(); }

  /// Forgets all motion; the motors stand at `place` now. A halt stays.
  void reset(const AxisArray<StepPosition>& place);

  /// Tells `observer` of every slice from now on; null for nobody.
  void observe(SliceObserver* observer) { observer_ = observer; }

 private:
  [[nodiscard]] bool ready_phase();
  void begin_block();
  void end_block();
  void follow_plan();
  void end_phase();
  [[nodiscard]] std::uint64_t fraction_after(const Phase& phase) const;
  [[nodiscard]] float phase_distance_left() const;
  [[nodiscard]] std::uint32_t slice_units() const;
  void cut(std::uint32_t units, Segment& segment);
  void time_trains(const MotorState& to, float duration, Segment& segment);
  [[nodiscard]] float duty_at(float speed) const;

  BlockQueue& queue_;
  const Limits& limits_;
  Overrides overrides_{};
  Drive drive_ = Drive::kOn;
  bool driving_ = false;  ///< The front block has been begun.
  bool replan_ = false;

  SpeedProfile profile_{};
  Drive phase_drive_ = Drive::kOn;
  Phase phase_{};
  PhaseCourse course_{};
  std::uint32_t units_done_ = 0;  ///< Of the course.
  bool near_reversal_ = false;    ///< Within the phase.
  std::uint64_t phase_from_ = 0;  ///< Fractions of the block.
  std::uint64_t phase_to_ = 0;

  MotorPath path_{};
  MotorState here_{};
  float speed_ = 0.0F;         ///< mm/s.
  float entry_square_ = 0.0F;  ///< v² with which the next block is begun.
  float fraction_per_mm_ = 0.0F;
  std::uint64_t fraction_ = 0;  ///< Of the block, 2^32 is its end.
  SliceObserver* observer_ = nullptr;
  std::uint32_t blocks_ended_ = 0;
  OutputChanges outputs_{};  ///< Not handed out yet.
  float shift_ = 0.0F;       ///< Planned time beyond the whole ticks handed out, in ticks.
};

}  // namespace cnc::motion
