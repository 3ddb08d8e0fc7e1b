#pragma once

#include "hal/interface/auxiliary_outputs.hpp"
#include "planner/gcode/action.hpp"

namespace cnc {

/// Mist and flood: what the program or the operator wants, and whether it is
/// interrupted (a door is open) meanwhile.
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
  /// Off and not interrupted, as after power-up.
  void reset() {
    suspended_ = false;
    set({});
  }

  [[nodiscard]] gcode::Coolant wanted() const { return wanted_; }
  /// What really flows.
  [[nodiscard]] gcode::Coolant now() const { return suspended_ ? gcode::Coolant{} : wanted_; }

 private:
  void apply() { outputs_.set_coolant(now().mist, now().flood); }

  hal::AuxiliaryOutputs& outputs_;
  gcode::Coolant wanted_{};
  bool suspended_ = false;
};

}  // namespace cnc
