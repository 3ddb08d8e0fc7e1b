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

/// What the motors do so that the tool does what is planned.
struct MotorStageSetting {
  AxisArray<ShaperSetting> shapers{};
  AxisArray<BacklashSetting> backlash{};
  AxisArray<float> most_steps_per_s{};  ///< Of each motor.
  bool dark_at_rest = false;            ///< A beam; a spindle turns before a motion and after it.
  constexpr bool operator==(const MotorStageSetting&) const = default;
};

/// The end of a cell, before and after shaping. Motor steps without backlash.
struct ShapedCell {
  const AxisArray<StepPosition>& planned;  ///< Of the newest cell…
  const AxisArray<StepPosition>& shaped;   ///< … and of that which goes out.
  std::uint32_t reach;                     ///< Cells whose places count for it.
  std::uint32_t duration_ns;
};

/// Whoever wants to see what shaping does.
class ShapingObserver {
 public:
  virtual void on_cell(const ShapedCell& cell) = 0;

 protected:
  ~ShapingObserver() = default;
};

/// Between the planned motion and the motors: input shaping, and then backlash.
///
/// Time goes on in cells (ShaperGrid). The plan is laid down slice by slice until a cell is
/// full; then the cell that lies `ahead` of it in time goes out, in as many segments as
/// the output has pieces in it. In a cell each motor goes along the parabola from place to
/// place that leaves with the mean speed of this cell and the one before.
///
/// Whoever begins a motion has the stage until it has come to rest. Main loop only.
class MotorStage {
 public:
  using Places = AxisArray<StepPosition>;
  using Steps = AxisArray<std::int32_t>;

  /// Motors are where their tools are from now on; reset() follows. @pre at_rest()
  void configure(const MotorStageSetting& setting);
  /// Any shaper or backlash is set; else segments are best made from the plan.
  [[nodiscard]] bool active() const { return active_; }

  /// The tool stands here, and the motors ahead of it by so much.
  void reset(const Places& tool, const Steps& ahead);

  /// Nothing is left of any motion.
  [[nodiscard]] bool at_rest() const { return at_rest_; }
  /// Who began the motion that is not at rest.
  [[nodiscard]] const void* owner() const { return owner_; }

  /// All backlash is taken up.
  [[nodiscard]] bool settled() const;

  // What is planned.

  /// ns until the present cell is full.
  [[nodiscard]] std::uint32_t room_ns() const { return cell_ns() - used_ns_; }
  /// The plan goes on, for `owner`. @pre the slice is at most room_ns() long; at_rest() or
  /// owner() is the same
  void add(const PlannedSlice& slice, const void* owner);
  /// It stands still for the rest of the cell.
  void rest();
  /// The next cell goes out. @pre room_ns() == 0, and take() has found nothing more
  void close_cell();

  // What goes out.

  /// The next segment; false when the cell is used up.
  [[nodiscard]] bool take(Segment& segment);

  /// Returns whether all of the cell that goes out was taken: the plan and the output are at the
  /// ends of cells.
  [[nodiscard]] bool between_cells() const { return out_tick_ == grid_.cell_ticks; }
  /// Returns the time in ticks from when a place is laid down until it goes out.
  [[nodiscard]] std::uint32_t ticks_ahead() const { return grid_.ahead * grid_.cell_ticks; }

  /// Tells `observer` of every cell from now on; null for nobody.
  void observe(ShapingObserver* observer) { observer_ = observer; }

  [[nodiscard]] const Backlash& backlash(std::size_t axis) const { return backlash_[axis]; }
  /// The axis's counter is set to say the tool's place. @pre at_rest(); reset() follows
  void rebase(std::size_t axis) { backlash_[axis].rebase(); }

 private:
  /// A motor within the cell that goes out.
  struct Course {
    StepPosition from{};
    StepPosition to{};
    float way = 0.0F;   ///< Steps.
    float lead = 0.0F;  ///< Steps in the cell at the speed of its start.
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

  // Of the cell being filled.
  std::uint32_t used_ns_ = 0;
  bool rests_ = true;       ///< No slice so far.
  Places tool_{};           ///< Where the plan has come to…
  SourceLine line_{};       ///< …and on which line.
  float rest_duty_ = 0.0F;  ///< When it stands still.
  std::uint32_t cells_at_rest_ = 0;

  PlaceHistory history_{};
  OutputDelay outputs_{};
  LineDelay lines_{};
  AxisArray<Backlash> backlash_{};

  // Of the cell that goes out.
  AxisArray<Course> courses_{};
  Places motors_{};             ///< Where the last segment ends.
  std::uint32_t out_tick_ = 0;  ///< How much of it is used; all where there is none.
  bool comes_to_rest_ = false;
};

}  // namespace cnc::motion
