#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/base/step_position.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// Slices of the plan that are joined to one segment. Holds the positions and speeds of the motors
/// at the start of the segment, and the planned duration of the slices so far.
///
/// A segment lasts a whole number of ticks. The rest of its planned duration is added to the next
/// segment.
class JoinedSlices {
 public:
  /// Begins a segment with the motors at `from`. A motor starts at speed 0 unless set_speed() is
  /// called.
  void begin(const AxisArray<StepPosition>& from) {
    from_ = from;
    speeds_ = {};
    duration_ns_ = 0;
  }
  /// Sets the speed of a motor.
  /// @param steps_per_tick speed at the start of the segment, signed
  void set_speed(std::size_t axis, float steps_per_tick) { speeds_[axis] = steps_per_tick; }
  void add(std::uint32_t duration_ns) { duration_ns_ += duration_ns; }

  [[nodiscard]] std::uint32_t duration_ns() const { return duration_ns_; }
  /// Returns the planned time, in ns, that earlier segments have left to this one. A negative value
  /// is time that earlier segments have taken in advance. @pre time() has not been called
  [[nodiscard]] std::int32_t rest_ns() const { return remainder_ns_; }
  /// Returns the distance from the start of the segment to `here`, in Q32 steps.
  [[nodiscard]] std::int64_t gone(std::size_t axis, StepPosition here) const {
    return here.q32() - from_[axis].q32();
  }

  /// Sets the step trains, the directions and the ticks of `segment`, which ends with the motors at
  /// `to`. A segment that is shorter than a tick, and needs no step to reach `to`, gets no ticks.
  /// @pre the step trains of `segment` are still empty
  void time(const AxisArray<StepPosition>& to, Segment& segment);
  /// Makes the segment last one tick. The next segment is shorter by that tick.
  void lend_tick(Segment& segment);

  /// Forgets the planned time that earlier segments have left, see rest_ns().
  void reset() { remainder_ns_ = 0; }

 private:
  void pass_time(Segment& segment);

  AxisArray<StepPosition> from_{};
  AxisArray<float> speeds_{};  ///< Speeds at the start of the segment, steps per tick.
  std::uint32_t duration_ns_ = 0;
  /// Planned time of the segments so far minus the time of their whole ticks, ns.
  std::int32_t remainder_ns_ = 0;
};

}  // namespace cnc::motion
