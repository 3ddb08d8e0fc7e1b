#pragma once

#include <cstdint>

#include "firmware/machine/dwell.hpp"
#include "firmware/machine/motion_control.hpp"
#include "firmware/machine/settings.hpp"
#include "firmware/steps/step_drive.hpp"
#include "hal/interface/machine_inputs.hpp"

namespace cnc {

/// Finds machine zero. Each axis seeks its switch, pulls off by $27, and then approaches the switch
/// slowly and pulls off again, $43 times. Passes $44…$49 determine which axes are homed together.
///
/// The step interrupt latches the step at which a switch closed, and the motors then brake within
/// their limits. So no step is lost, and the overrun after the switch does not affect the result.
/// If the axes of one pass reach their switches at different times, all of them stop whenever one
/// axis reaches its switch. The axes that have not reached their switches then continue. On an axis
/// with two motors ($852), each motor stops at its own switch and waits for the other motor. This
/// squares the axis.
class Homing {
 public:
  enum class Outcome : std::uint8_t {
    kGoingOn,
    kDone,
    kNoSwitch,      ///< No switch was found within 1.5 times the travel.
    kStillClosed,   ///< A switch is still closed after the pull-off.
    kSecondSwitch,  ///< One of two motors did not reach its switch in time.
  };

  Homing(StepDrive& drive, MotionControl& motion, const Settings& settings)
      : drive_{drive}, motion_{motion}, settings_{settings} {}

  /// Begins homing.
  /// @param axes bit i for axis i; 0 for all axes that are in a pass
  /// @pre nothing is planned and nothing moves
  void start(std::uint8_t axes, const motion::BeamCommand& beam);

  /// Continues homing; to be called in each cycle.
  /// @param read present inputs without filtering, because homing waits for the time $26 after a
  ///     motion before it uses them
  [[nodiscard]] Outcome poll(const hal::InputState& read, std::int32_t elapsed_us);
  /// Cancels homing. The caller must stop the motion.
  void cancel() { drive_.unwatch_switches(); }

  /// Returns the axes that have been homed in the completed passes, bit i for axis i.
  [[nodiscard]] std::uint8_t found() const { return done_; }

 private:
  enum class Step : std::uint8_t { kApproach, kBrake, kSettle, kPullOff, kPulledOff };

  [[nodiscard]] bool next_pass();
  [[nodiscard]] Outcome begin_approach();
  [[nodiscard]] Outcome go_on_approaching();
  [[nodiscard]] Outcome attend_approach();
  [[nodiscard]] Outcome after_stop();
  [[nodiscard]] Outcome pull_off();
  [[nodiscard]] Outcome after_pull_off(const hal::InputState& read);
  [[nodiscard]] Outcome finish_pass();
  void settle(Step next);

  [[nodiscard]] static bool moves(std::size_t axis, std::uint8_t mask) {
    return (mask >> axis & 1U) != 0;
  }
  [[nodiscard]] bool homes_low(std::size_t axis) const;
  [[nodiscard]] std::uint8_t squared() const;
  [[nodiscard]] Coordinate search_distance(std::size_t axis) const;
  [[nodiscard]] Coordinate greatest_skew(std::size_t axis) const;
  [[nodiscard]] Coordinate pull_off_distance() const;
  [[nodiscard]] Coordinate switch_place(std::size_t axis) const;
  [[nodiscard]] Outcome not_found() const;
  [[nodiscard]] Outcome move_to(const Position& end, float feed_mm_min);

  StepDrive& drive_;
  MotionControl& motion_;
  const Settings& settings_;
  motion::BeamCommand beam_{};
  Dwell dwell_{};
  Step step_ = Step::kApproach;
  std::uint8_t wanted_ = 0;  ///< Requested axes that are not homed yet.
  std::uint8_t done_ = 0;
  std::uint8_t axes_ = 0;                ///< Axes of this pass.
  std::uint8_t left_ = 0;                ///< Axes of this pass that have not found their switch.
  std::uint32_t pass_ = 0;               ///< Index of the next pass.
  std::uint32_t locates_ = 0;            ///< Number of slow approaches begun; 0 in the fast search.
  Position from_{};                      ///< Start of this approach.
  AxisArray<std::int32_t> closed_at_{};  ///< Tool position, in steps, at which each switch closed.
};

}  // namespace cnc
