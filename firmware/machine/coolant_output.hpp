#pragma once

#include "hal/interface/auxiliary_outputs.hpp"
#include "planner/gcode/action.hpp"

namespace cnc {

/// Outputs for mist and flood: the state that the program or the operator has set, and whether both
/// are suspended because a door is open.
class CoolantOutput {
 public:
  explicit CoolantOutput(hal::AuxiliaryOutputs& outputs) : outputs_{outputs} {}

  void set(gcode::Coolant wanted) {
    wanted_ = wanted;
    apply();
  }
  void suspend(bool suspended) {
    suspended_ = suspended;
    apply();
  }
  /// Switches mist and flood off and ends the suspension. This is the state after power-up.
  void reset() {
    suspended_ = false;
    set({});
  }

  [[nodiscard]] gcode::Coolant wanted() const { return wanted_; }
  /// Returns the state of the outputs: the set state, or off while suspended.
  [[nodiscard]] gcode::Coolant now() const { return suspended_ ? gcode::Coolant{} : wanted_; }

 private:
  void apply() { outputs_.set_coolant(now().mist, now().flood); }

  hal::AuxiliaryOutputs& outputs_;
  gcode::Coolant wanted_{};
  bool suspended_ = false;
};

}  // namespace cnc
