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

/// Returns a share of full output as a duty, 65535 for all of it; beyond 0…1 the nearer of them.
[[nodiscard]] std::uint16_t to_full_scale(float share);

/// What the operator's settings say about the tool ($30…$32).
struct ToolSettings {
  float most_speed = 1000.0F;
  float least_speed = 0.0F;
  bool laser = false;
};

/// The beam or spindle: what M3, M4, M5 and S make of the power output.
///
/// A laser's power goes with the motion and is off whenever nothing moves. A
/// spindle turns on its own, so a new speed waits for standstill and holds
/// through rapids.
class ToolOutput {
 public:
  ToolOutput(StepDrive& drive, hal::AuxiliaryOutputs& outputs) : drive_{drive}, outputs_{outputs} {}

  void configure(const ToolSettings& settings);

  /// Whether a change of speed must wait until the machine stands still. A
  /// change of mode always does: it switches the enable.
  [[nodiscard]] bool speed_waits_for_standstill() const { return !settings_.laser; }

  void set_mode(gcode::SpindleMode mode);
  void set_speed(float speed);
  void set_override(float factor);
  /// Interrupts the tool without forgetting it: a door, a tool change, the
  /// operator's spindle stop. A beam is dark at once, whatever still moves.
  void suspend(bool suspended);
  [[nodiscard]] bool suspended() const { return suspended_; }
  void off() { set_mode(gcode::SpindleMode::kOff); }
  /// Off, with the speed forgotten, as after power-up.
  void reset();

  /// The share of the greatest power that S and the override mean, 0…1; 0 with M5.
  [[nodiscard]] float share_now() const;
  /// What a beam gives where nothing moves from now on; 65535 is full. Any change of mode to M5,
  /// and suspend(), end it.
  void light_at_rest(std::uint16_t duty);

  /// Returns what command_for() makes of values of S while a beam works: their powers.
  [[nodiscard]] path::RowPowers powers_of(std::span<const float> speeds) const {
    return {.values = speeds, .least = least_speed(), .full = settings_.most_speed};
  }
  /// For the motion that comes next.
  [[nodiscard]] motion::BeamCommand command_for(bool rapid) const;

  [[nodiscard]] gcode::SpindleMode mode() const { return mode_; }
  /// What it really does.
  [[nodiscard]] gcode::SpindleMode mode_now() const {
    return suspended_ ? gcode::SpindleMode::kOff : mode_;
  }
  [[nodiscard]] bool is_laser() const { return settings_.laser; }
  /// Any context. The output is dark before this says so, and as long as it does, at rest, but for
  /// what light_at_rest() allows.
  [[nodiscard]] bool is_dark_at_rest() const {
    return dark_at_rest_.load(std::memory_order_relaxed);
  }
  /// What configure() was told.
  [[nodiscard]] const ToolSettings& settings() const { return settings_; }
  /// S that gives full output.
  [[nodiscard]] float most_speed() const { return settings_.most_speed; }
  [[nodiscard]] float speed() const { return speed_; }

 private:
  [[nodiscard]] float least_speed() const {
    return std::min(settings_.least_speed, settings_.most_speed);
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
