#pragma once

#include <algorithm>
#include <atomic>
#include <span>

#include "firmware/steps/step_drive.hpp"
#include "hal/interface/auxiliary_outputs.hpp"
#include "planner/gcode/action.hpp"
#include "planner/motion/block/block.hpp"
#include "planner/path/path_item.hpp"

namespace cnc {

/// Returns a share of full output as a duty; 65535 is full. A share outside 0…1 is clamped.
[[nodiscard]] std::uint16_t to_full_scale(float share);

/// Settings of the tool ($30…$32).
struct ToolSettings {
  float max_speed = 1000.0F;
  float min_speed = 0.0F;
  bool laser = false;
};

/// The beam or spindle: sets the power output by M3, M4, M5 and S.
///
/// The power of a laser follows the motion and is off at rest. A spindle turns independently of the
/// motion, so a new speed waits for standstill and stays during rapids.
class ToolOutput {
 public:
  ToolOutput(StepDrive& drive, hal::AuxiliaryOutputs& outputs) : drive_{drive}, outputs_{outputs} {}

  void configure(const ToolSettings& settings);

  /// Returns whether a change of speed must wait for standstill. A change of mode always must,
  /// because it switches the enable output.
  [[nodiscard]] bool speed_waits_for_standstill() const { return !settings_.laser; }

  void set_mode(gcode::SpindleMode mode);
  void set_speed(float speed);
  void set_override(float factor);
  /// Interrupts the tool without changing its mode: for a door, a tool change, the operator's
  /// spindle stop. A beam goes off at once, even if the machine still moves.
  void suspend(bool suspended);
  [[nodiscard]] bool suspended() const { return suspended_; }
  void off() { set_mode(gcode::SpindleMode::kOff); }
  /// Switches off and sets the speed to 0, as after power-up.
  void reset();

  /// Returns the share of full power by S and the override, 0…1; 0 with M5.
  [[nodiscard]] float share_now() const;
  /// Sets the duty of a beam at rest from now on; 65535 is full. A change of mode to M5 ends it,
  /// and so does suspend().
  void light_at_rest(std::uint16_t duty);

  /// Returns the powers that command_for() would give for values of S while a beam works.
  [[nodiscard]] path::RowPowers powers_of(std::span<const float> speeds) const {
    return {.values = speeds, .least = min_speed(), .full = settings_.max_speed};
  }
  /// Returns the beam command of the next motion.
  [[nodiscard]] motion::BeamCommand command_for(bool rapid) const;

  [[nodiscard]] gcode::SpindleMode mode() const { return mode_; }
  /// Returns the real mode, which is off while suspended.
  [[nodiscard]] gcode::SpindleMode mode_now() const {
    return suspended_ ? gcode::SpindleMode::kOff : mode_;
  }
  [[nodiscard]] bool is_laser() const { return settings_.laser; }
  /// Returns whether the output is off at rest, except for light that light_at_rest() allows. The
  /// output is off before this becomes true. Any context.
  [[nodiscard]] bool is_dark_at_rest() const {
    return dark_at_rest_.load(std::memory_order_relaxed);
  }
  /// Returns the settings of configure().
  [[nodiscard]] const ToolSettings& settings() const { return settings_; }
  /// Returns the S that gives full output.
  [[nodiscard]] float max_speed() const { return settings_.max_speed; }
  [[nodiscard]] float speed() const { return speed_; }

 private:
  [[nodiscard]] float min_speed() const {
    return std::min(settings_.min_speed, settings_.max_speed);
  }
  [[nodiscard]] float duty() const;
  void apply();

  StepDrive& drive_;
  hal::AuxiliaryOutputs& outputs_;
  ToolSettings settings_{};
  std::atomic<bool> dark_at_rest_{false};
  gcode::SpindleMode mode_ = gcode::SpindleMode::kOff;
  float speed_ = 0.0F;
  float override_ = 1.0F;
  std::uint16_t light_at_rest_ = 0;
  bool suspended_ = false;
};

}  // namespace cnc
