#pragma once

#include "hal/interface/auxiliary_outputs.hpp"
#include "planner/gcode/action.hpp"

namespace cnc {

/// Mist and flood: the state that the program or the operator has set, and whether it is suspended
/// (because a door is open).
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
  /// Switches both off and ends the suspension, as after power-up.
  void reset() {
    suspended_ = false;
    set({});
  }

  [[nodiscard]] gcode::Coolant wanted() const { return wanted_; }
  /// Returns the coolant that really flows.
  [[nodiscard]] gcode::Coolant now() const { return suspended_ ? gcode::Coolant{} : wanted_; }

 private:
  void apply() { outputs_.set_coolant(now().mist, now().flood); }

  hal::AuxiliaryOutputs& outputs_;
  gcode::Coolant wanted_{};
  bool suspended_ = false;
};

}  // namespace cnc
