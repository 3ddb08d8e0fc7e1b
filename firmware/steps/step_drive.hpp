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
  std::uint32_t pulse = 20;            ///< A step input is high this long, and then low as long.
  std::uint32_t direction_set_up = 8;  ///< From a direction change to the next leading edge.
};

/// How far ahead of the motors segments are cut: long enough for the main loop
/// to be away, short enough that a hold is felt at once.
inline constexpr std::uint32_t kTicksAhead = motion::kTicksPerSecond / 50;

/// The step generator as the main loop sees it: somewhere to put segments.
/// Main loop context; nothing here blocks. What it tells is as it was when the turn began.
class StepDrive {
 public:
  [[nodiscard]] virtual bool full() const = 0;
  /// @pre !full()
  virtual void push(const motion::Segment& segment) = 0;
  /// Motion handed over and not yet begun, in ticks of the step clock.
  [[nodiscard]] virtual std::uint32_t ticks_waiting() const = 0;
  /// How much of it there should be: kTicksAhead, and what the beam's delays need.
  [[nodiscard]] virtual std::uint32_t ticks_ahead() const = 0;
  /// There is room for a segment, and less motion waits than there should be.
  [[nodiscard]] bool wants_more() const { return !full() && ticks_waiting() < ticks_ahead(); }
  /// Call when all that is to be pushed in this turn has been.
  virtual void settle() = 0;
  /// Something moves, or waits to be driven.
  [[nodiscard]] virtual bool running() const = 0;
  /// At once, without waiting for a boundary: ends motion at once, where it is, and drops what
  /// waits. The motors may lose steps when they were fast.
  virtual void abort() = 0;
  /// True once after motion was cut off because no segment came in time. Nothing moves from then on
  /// until abort() has dropped what waits.
  [[nodiscard]] virtual bool take_starved() = 0;

  /// Turns that took so long that motion may have begun later than it should.
  [[nodiscard]] virtual std::uint32_t late_turns() const = 0;
  /// Returns whether older turns were due and not over when this one began: it does no more than
  /// the motion under way needs, so that the main loop is in time again before motion is cut off.
  [[nodiscard]] virtual bool catches_up() const = 0;

  /// Motor positions in steps.
  [[nodiscard]] virtual AxisArray<std::int32_t> position() const = 0;
  /// Where in the program what the motors do comes from, or did last.
  [[nodiscard]] virtual motion::SourceLine line() const = 0;
  /// Duty of the output when nothing moves, 65535 is full: 0 for a beam. At once
  /// at rest, and where it is 0.
  virtual void set_rest_power(std::uint16_t power) = 0;
  /// Keeps the output at 0 from the next interrupt on, within a millisecond,
  /// whatever segments and the rest power say; or no longer.
  virtual void block_power(bool blocked) = 0;
  /// Running count of the ticks of motion that were handed over.
  [[nodiscard]] virtual std::uint32_t ticks_handed_over() const = 0;
  /// Tick of the motion, as ticks_handed_over() counts, at which the light ended when the output
  /// was blocked last. @pre it was blocked, !running()
  [[nodiscard]] virtual std::uint32_t light_ended() const = 0;
  /// Duty of the output.
  [[nodiscard]] virtual std::uint16_t power() const = 0;
  /// @pre !running(), and nothing waits
  virtual void set_beam_timing(const BeamTiming& timing) = 0;
  /// @pre !running()
  virtual void set_timing(const StepTiming& timing) = 0;

  /// Axes with a second motor that steps with the first. @pre !running()
  virtual void set_second_motors(std::uint8_t axes) = 0;
  /// The memory of timing and second motors: nobody but these two functions changes it.
  [[nodiscard]] virtual std::span<const std::byte> set_up_memory() const = 0;
  /// The motor stands where it is; that is this many steps now. @pre !running()
  virtual void set_position(std::size_t axis, std::int32_t steps) = 0;

  /// Latches the position of each of these axes at the first step after which
  /// its limit switch reads closed. On `squared` ones both motors have to reach
  /// their own switch: the one that is there first gets no more steps until the
  /// other is, too. Axes watched before stay so. @pre !running()
  virtual void watch_switches(std::uint8_t axes, std::uint8_t squared) = 0;
  virtual void unwatch_switches() = 0;
  /// Watched axes that found their switch.
  [[nodiscard]] virtual std::uint8_t switches_found() const = 0;
  /// Watched axes of which one motor waits for the other.
  [[nodiscard]] virtual std::uint8_t switches_half_found() const = 0;
  /// Where it closed, and how many steps one motor waited. @pre it was found
  [[nodiscard]] virtual std::int32_t switch_position(std::size_t axis) const = 0;
  [[nodiscard]] virtual std::int32_t switch_skew(std::size_t axis) const = 0;

  /// Whether the probe input reports contact now.
  [[nodiscard]] virtual bool probe_contact() const = 0;
  /// Latches the position at the first step after which the probe input reads
  /// `contact`. @pre !running()
  virtual void arm_probe(bool contact) = 0;
  virtual void disarm_probe() = 0;
  [[nodiscard]] virtual bool probe_hit() const = 0;
  /// @pre probe_hit()
  [[nodiscard]] virtual AxisArray<std::int32_t> probe_position() const = 0;

 protected:
  ~StepDrive() = default;
};

}  // namespace cnc
