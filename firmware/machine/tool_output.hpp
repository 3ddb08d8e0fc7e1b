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

/// Converts a share of full output to a duty; 65535 is full. A share outside 0…1 is clamped to this
/// range.
[[nodiscard]] std::uint16_t to_full_scale(float share);

/// Settings of the tool ($30…$32).
struct ToolSettings {
  float max_speed = 1000.0F;
  float min_speed = 0.0F;
  bool laser = false;
};

/// The output for the beam or spindle. It follows M3, M4, M5 and S.
///
/// The power of a laser follows the motion and is off at rest. The speed of a spindle does not
/// depend on the motion. It changes only at standstill, and it stays during rapids.
class ToolOutput {
 public:
  ToolOutput(StepDrive& drive, hal::AuxiliaryOutputs& outputs) : drive_{drive}, outputs_{outputs} {}

  void configure(const ToolSettings& settings);

  /// Returns whether a change of S must wait for standstill. A change of the mode must always wait,
  /// because it switches the enable output.
  [[nodiscard]] bool speed_waits_for_standstill() const { return !settings_.laser; }

  void set_mode(gcode::SpindleMode mode);
  void set_speed(float speed);
  void set_override(float factor);
  /// If `suspended`, switches the tool off without a change of its mode: for a door, a tool change,
  /// a lost link or a spindle stop. A beam goes off immediately, even if the machine still moves.
  /// If not `suspended`, restores the tool.
  void suspend(bool suspended);
  [[nodiscard]] bool suspended() const { return suspended_; }
  void off() { set_mode(gcode::SpindleMode::kOff); }
  /// Switches the tool off and sets S to 0, the state after power-up.
  void reset();

  /// Returns the share of full power that S and the override give, 0…1; 0 under M5.
  [[nodiscard]] float share_now() const;
  /// Sets the duty of a beam at rest; 65535 is full. The output is 0 while the mode is M5 or the
  /// tool is suspended.
  void light_at_rest(std::uint16_t duty);

  /// Returns the powers for the values `speeds` of S in a row. While a beam is on, each equals the
  /// power of command_for() for the same S.
  [[nodiscard]] path::RowPowers powers_of(std::span<const float> speeds) const {
    return {.values = speeds, .least = min_speed(), .full = settings_.max_speed};
  }
  /// Returns the beam command for the next motion.
  /// @param rapid whether this motion is a rapid, in which a beam is off
  [[nodiscard]] motion::BeamCommand command_for(bool rapid) const;

  [[nodiscard]] gcode::SpindleMode mode() const { return mode_; }
  /// Returns the effective mode: off while the tool is suspended, otherwise mode().
  [[nodiscard]] gcode::SpindleMode mode_now() const {
    return suspended_ ? gcode::SpindleMode::kOff : mode_;
  }
  [[nodiscard]] bool is_laser() const { return settings_.laser; }
  /// Returns whether the output is off at rest, except for the duty of light_at_rest(). This
  /// becomes true only after the output was switched off. Any context.
  [[nodiscard]] bool is_dark_at_rest() const {
    return dark_at_rest_.load(std::memory_order_relaxed);
  }
  /// Returns the settings that configure() has set.
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
