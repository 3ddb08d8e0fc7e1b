#pragma once

#include "hal/interface/auxiliary_outputs.hpp"
#include "hal/interface/machine_inputs.hpp"
#include "hal/interface/step_port.hpp"

/// Common part of all step ports here: no switch closes, the probe touches nothing, and outputs
/// other than those of the motors and the beam have no effect.
class QuietMachine : public hal::AuxiliaryOutputs, public hal::MachineInputs {
 public:
  void change_outputs(std::uint8_t, std::uint8_t) noexcept {}
  void set_analog(std::uint8_t, std::uint16_t) noexcept {}
  void start_timer() noexcept { started = true; }
  [[nodiscard]] bool probe_contact() const noexcept { return false; }
  [[nodiscard]] hal::SwitchMask switches() const noexcept { return {}; }

  void set_spindle(bool, bool) final {}
  void set_coolant(bool, bool) final {}
  void set_digital(std::uint8_t, bool) final {}
  void set_analog_output(std::uint8_t, std::uint16_t) final {}
  void set_motors_enabled(std::uint8_t) final {}
  [[nodiscard]] hal::InputState read_inputs() final { return {}; }

  bool started = false;

 protected:
  ~QuietMachine() = default;
};
