#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/steps/power_shift.hpp"
#include "planner/base/axes.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// Electrical timing of the motor drivers, in ticks of the step clock.
struct StepTiming {
  /// Length of the high level of a step pulse, and of the low level after it.
  std::uint32_t pulse = 20;
  /// Time from a direction change to the leading edge of the next step pulse.
  std::uint32_t direction_set_up = 8;
};

/// Length of the motion that is cut into segments ahead of the motors: long enough for delays of
/// the main loop, short enough that a hold acts without noticeable delay.
inline constexpr std::uint32_t kTicksAhead = motion::kTicksPerSecond / 50;

/// Interface of the step generator, to which the main loop pushes segments. Main loop context; no
/// function blocks. Returned values are those at the beginning of the present cycle.
class StepDrive {
 public:
  [[nodiscard]] virtual bool full() const = 0;
  /// Appends a segment.
  /// @pre !full()
  virtual void push(const motion::Segment& segment) = 0;
  /// Returns the length of the motion that was handed over and has not begun, in ticks of the step
  /// clock.
  [[nodiscard]] virtual std::uint32_t ticks_waiting() const = 0;
  /// Returns the length of waiting motion that the main loop should maintain, in ticks:
  /// kTicksAhead, plus the length that the delays of the beam require.
  [[nodiscard]] virtual std::uint32_t ticks_ahead() const = 0;
  /// Returns whether another segment fits, and the waiting motion is shorter than ticks_ahead().
  [[nodiscard]] bool wants_more() const { return !full() && ticks_waiting() < ticks_ahead(); }
  /// Ends the pushes of this cycle; to be called after the last push().
  virtual void settle() = 0;
  /// Returns whether motion is in progress or waits.
  [[nodiscard]] virtual bool running() const = 0;
  /// Ends all motion immediately, without waiting for a boundary, and drops waiting motion. If the
  /// motors were fast, they may lose steps.
  virtual void abort() = 0;
  /// Returns true once after motion was cut off because no segment came in time. From then on
  /// nothing moves until abort() has dropped the waiting motion.
  [[nodiscard]] virtual bool take_starved() = 0;

  /// Returns the number of boundaries at which a due cycle was not complete, so that motion may
  /// have begun too late.
  [[nodiscard]] virtual std::uint32_t late_turns() const = 0;
  /// Returns whether older cycles were due and not complete at the boundary of the present cycle.
  /// The present cycle then does only the work that the motion in progress requires, so that the
  /// main loop is in time again before motion is cut off.
  [[nodiscard]] virtual bool catches_up() const = 0;

  /// Returns the motor positions in steps.
  [[nodiscard]] virtual AxisArray<std::int32_t> position() const = 0;
  /// Returns the program line of the motors' present motion; at rest, of their last motion.
  [[nodiscard]] virtual motion::SourceLine line() const = 0;
  /// Sets the duty of the output at rest; 65535 is full. For a beam it is 0, except while the beam
  /// must be on at rest. It takes effect immediately if the machine is at rest or `power` is 0.
  virtual void set_rest_power(std::uint16_t power) = 0;
  /// Keeps the output at 0 from the next interrupt on, within a millisecond, regardless of segments
  /// and the duty at rest. `blocked` = false ends this.
  virtual void block_power(bool blocked) = 0;
  /// Returns the number of ticks of motion that were pushed so far (wraps).
  [[nodiscard]] virtual std::uint32_t ticks_handed_over() const = 0;
  /// Returns the tick of the motion, as ticks_handed_over() counts, at which the light ended when
  /// the output was blocked last.
  /// @pre the output was blocked, !running()
  [[nodiscard]] virtual std::uint32_t light_ended() const = 0;
  /// Returns the duty of the output.
  [[nodiscard]] virtual std::uint16_t power() const = 0;
  /// Sets the delays of the beam.
  /// @pre !running(), and no motion waits
  virtual void set_beam_timing(const BeamTiming& timing) = 0;
  /// Sets the timing of the drivers.
  /// @pre !running()
  virtual void set_timing(const StepTiming& timing) = 0;

  /// Sets the axes, bit i for axis i, that have a second motor, which steps with the first.
  /// @pre !running()
  virtual void set_second_motors(std::uint8_t axes) = 0;
  /// Returns the memory of the timing and the second motors. Only set_timing() and
  /// set_second_motors() change it, so that any other change is a fault.
  [[nodiscard]] virtual std::span<const std::byte> set_up_memory() const = 0;
  /// Sets the step count of a motor without moving it.
  /// @pre !running()
  virtual void set_position(std::size_t axis, std::int32_t steps) = 0;

  /// Begins to watch limit switches: latches the position of each of these axes at the first step
  /// after which its limit switch reads closed. On axes in `squared` both motors must reach their
  /// own switches: the first motor that reaches its switch gets no more steps until the other motor
  /// has reached its own switch. Axes that were watched before stay watched.
  /// @pre !running()
  virtual void watch_switches(std::uint8_t axes, std::uint8_t squared) = 0;
  virtual void unwatch_switches() = 0;
  /// Returns the watched axes that have found their switch.
  [[nodiscard]] virtual std::uint8_t switches_found() const = 0;
  /// Returns the watched axes on which one motor waits for the other motor.
  [[nodiscard]] virtual std::uint8_t switches_half_found() const = 0;
  /// Return the position at which the switch closed, and the number of steps for which one motor
  /// waited.
  /// @pre the switch was found
  [[nodiscard]] virtual std::int32_t switch_position(std::size_t axis) const = 0;
  [[nodiscard]] virtual std::int32_t switch_skew(std::size_t axis) const = 0;

  /// Returns whether the probe input reports contact now.
  [[nodiscard]] virtual bool probe_contact() const = 0;
  /// Arms the probe: latches the position at the first step after which the probe input reads
  /// `contact`.
  /// @pre !running()
  virtual void arm_probe(bool contact) = 0;
  virtual void disarm_probe() = 0;
  [[nodiscard]] virtual bool probe_hit() const = 0;
  /// Returns the latched position.
  /// @pre probe_hit()
  [[nodiscard]] virtual AxisArray<std::int32_t> probe_position() const = 0;

 protected:
  ~StepDrive() = default;
};

}  // namespace cnc
