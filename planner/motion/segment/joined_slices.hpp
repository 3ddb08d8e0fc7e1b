#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/base/step_position.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {

/// Slices of the plan that go out as one segment: where the motors were and how fast at its
/// start, and how long it has become.
///
/// Segments last whole ticks; what planned time is left of one goes to the next.
class JoinedSlices {
 public:
  /// The motors stand at `from`, and those of which no speed is said do not move.
  void begin(const AxisArray<StepPosition>& from) {
    from_ = from;
    speeds_ = {};
    duration_ns_ = 0;
  }
  /// @param steps_per_tick at the start, signed
  void set_speed(std::size_t axis, float steps_per_tick) { speeds_[axis] = steps_per_tick; }
  void add(std::uint32_t duration_ns) { duration_ns_ += duration_ns; }

  [[nodiscard]] std::uint32_t duration_ns() const { return duration_ns_; }
  /// Planned time, ns, that the segments so far have left to this one; negative: that they took.
  /// @pre time() has not been called
  [[nodiscard]] std::int32_t rest_ns() const { return remainder_ns_; }
  /// Q32 steps from the start to `here`.
  [[nodiscard]] std::int64_t gone(std::size_t axis, StepPosition here) const {
    return here.q32() - from_[axis].q32();
  }

  /// Trains, directions and ticks of the segment, which ends with the motors at `to`. Less than a
  /// tick without a step is none. @pre no train of it has a step
  void time(const AxisArray<StepPosition>& to, Segment& segment);
  /// The segment lasts a tick, for which the next one is the shorter.
  void lend_tick(Segment& segment);

  /// Forgets what time is left.
  void reset() { remainder_ns_ = 0; }

 private:
  void pass_time(Segment& segment);

  AxisArray<StepPosition> from_{};
  AxisArray<float> speeds_{};  ///< Steps per tick.
  std::uint32_t duration_ns_ = 0;
  std::int32_t remainder_ns_ = 0;  ///< Planned time beyond the whole ticks handed out.
};

}  // namespace cnc::motion
