#pragma once

#include <cstdint>

#include "planner/motion/motors/backlash.hpp"
#include "planner/motion/motors/line_delay.hpp"
#include "planner/motion/motors/output_delay.hpp"
#include "planner/motion/motors/place_history.hpp"
#include "planner/motion/motors/shaper_grid.hpp"
#include "planner/motion/segment/planned_slice.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// Settings of MotorStage.
struct MotorStageSetting {
  AxisArray<ShaperSetting> shapers{};
  AxisArray<BacklashSetting> backlash{};
  AxisArray<float> max_steps_per_s{};  ///< Greatest step rate of each motor.
  /// True if the output is off at rest, as for a beam. False for a spindle, which turns before and
  /// after a motion.
  bool dark_at_rest = false;
  constexpr bool operator==(const MotorStageSetting&) const = default;
};

/// Positions before and after shaping, in motor steps without backlash.
struct ShapedCell {
  const AxisArray<StepPosition>& planned;  ///< Planned positions at the end of the newest cell.
  /// Shaped positions at the end of the cell that is being output.
  const AxisArray<StepPosition>& shaped;
  /// Total number of cells before and after the output cell that contribute to `shaped`.
  std::uint32_t reach;
  std::uint32_t duration_ns;
};

/// Receives the positions of each cell before and after shaping.
class ShapingObserver {
 public:
  virtual void on_cell(const ShapedCell& cell) = 0;

 protected:
  ~ShapingObserver() = default;
};

/// Makes the motion of the motors from the planned motion, by input shaping and then backlash.
///
/// Time is divided into cells of equal duration (ShaperGrid). The plan is added slice by slice
/// until a cell is full. Then the cell that was planned ShaperGrid::ahead cells earlier is output,
/// as one segment for each piece of its output (OutputPiece). In a cell, each motor moves along a
/// parabola over time from position to position. The start speed of the parabola is the mean of the
/// mean speeds of this cell and the cell before.
///
/// The first slice of a motion sets the owner of the motion. Only this owner may add slices until
/// the motion has come to rest. Main loop only.
class MotorStage {
 public:
  using Places = AxisArray<StepPosition>;
  using Steps = AxisArray<std::int32_t>;

  /// Applies a setting. From now on the counters of the motors equal the positions of the tool.
  /// reset() must follow. @pre at_rest()
  void configure(const MotorStageSetting& setting);
  /// Returns whether any shaper or backlash is set. If not, segments can be made directly from the
  /// plan.
  [[nodiscard]] bool active() const { return active_; }

  /// Sets the state at rest: the tool is at `tool`, and the counters of the motors are ahead of it
  /// by `ahead`.
  void reset(const Places& tool, const Steps& ahead);

  /// Returns whether all motion has been output and the motors are at rest.
  [[nodiscard]] bool at_rest() const { return at_rest_; }
  /// Returns the owner of the present motion, or null at rest.
  [[nodiscard]] const void* owner() const { return owner_; }

  /// Returns whether the backlash of all axes is taken up.
  [[nodiscard]] bool settled() const;

  // Input: the planned motion.

  /// Returns the time in ns that is missing until the present cell is full.
  [[nodiscard]] std::uint32_t room_ns() const { return cell_ns() - used_ns_; }
  /// Adds a slice of the plan.
  /// @param owner identifies the source of the slices, a segmenter
  /// @pre the duration of the slice is at most room_ns(); at_rest(), or `owner` is owner()
  void add(const PlannedSlice& slice, const void* owner);
  /// Fills the rest of the present cell with a plan at rest.
  void rest();
  /// Closes the full cell, so that the next cell is output.
  /// @pre room_ns() == 0, and take() has returned false
  void close_cell();

  // Output: the segments.

  /// Takes the next segment. Returns false if there is none left in the cell that is being output.
  [[nodiscard]] bool take(Segment& segment);

  /// Returns whether take() has returned all segments of the cell that is being output. Then the
  /// plan and the output are both at the end of a cell.
  [[nodiscard]] bool between_cells() const { return out_tick_ == grid_.cell_ticks; }
  /// Returns the delay in ticks from the planning of a position to its output.
  [[nodiscard]] std::uint32_t ticks_ahead() const { return grid_.ahead * grid_.cell_ticks; }

  /// Reports every cell to `observer` from now on; null stops the reports.
  void observe(ShapingObserver* observer) { observer_ = observer; }

  [[nodiscard]] const Backlash& backlash(std::size_t axis) const { return backlash_[axis]; }
  /// Makes the counter of an axis equal to the position of the tool. @pre at_rest(); reset() must
  /// follow
  void rebase(std::size_t axis) { backlash_[axis].rebase(); }

 private:
  /// Motion of a motor within the cell that is being output.
  struct Course {
    StepPosition from{};
    StepPosition to{};
    float way = 0.0F;   ///< Steps that the motor makes in the cell.
    float lead = 0.0F;  ///< Steps that the motor would make at its start speed.
  };

  [[nodiscard]] std::uint32_t cell_ns() const;
  [[nodiscard]] float cell_seconds() const;
  void begin(const PlannedSlice& slice, const void* owner);
  void lay_course(std::size_t axis, StepPosition tool);
  [[nodiscard]] StepPosition place_at(const Course& course, std::uint32_t tick) const;
  void time_train(std::size_t axis, std::uint32_t end_tick, Segment& segment);

  MotorStageSetting setting_{};
  ShaperGrid grid_{};
  bool active_ = false;
  bool at_rest_ = true;
  const void* owner_ = nullptr;
  ShapingObserver* observer_ = nullptr;

  // Values of the cell that is being filled.
  std::uint32_t used_ns_ = 0;
  bool rests_ = true;       ///< True while no slice was added to the cell.
  Places tool_{};           ///< Position that the plan has reached.
  SourceLine line_{};       ///< Source line of the plan at this position.
  float rest_duty_ = 0.0F;  ///< Duty at rest, 0…1.
  std::uint32_t cells_at_rest_ = 0;

  PlaceHistory history_{};
  OutputDelay outputs_{};
  LineDelay lines_{};
  AxisArray<Backlash> backlash_{};

  // Values of the cell that is being output.
  AxisArray<Course> courses_{};
  Places motors_{};  ///< Positions of the motors at the end of the last segment.
  /// Ticks of the cell that take() has returned; all ticks if no cell is being output.
  std::uint32_t out_tick_ = 0;
  bool comes_to_rest_ = false;
};

}  // namespace cnc::motion
