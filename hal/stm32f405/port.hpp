#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/interface/auxiliary_outputs.hpp"
#include "hal/interface/machine_inputs.hpp"
#include "hal/interface/step_port.hpp"
#include "hal/stm32f405/inputs.hpp"
#include "hal/stm32f405/pin_group.hpp"
#include "hal/stm32f405/polarity.hpp"
#include "hal/stm32f405/power_pin.hpp"
#include "hal/stm32f405/step_timer.hpp"

namespace hal::stm32f405 {

/// All pins of a board, with the interfaces that the firmware requires.
template <const Board& kBoard, RegisterBus Bus = MemoryBus>
class Port final : public AuxiliaryOutputs, public MachineInputs {
 public:
  /// Sets up all pins and timers. Motors have no current, and outputs are off. Called once, with
  /// interrupts off.
  void set_up(const Clocks& clocks) noexcept {
    clocks_ = clocks;
    set_up_at_rest();
    inputs_.set_up();
    power_.set_up(clocks);
    timer_.set_up(clocks);
  }
  /// Sets up only the pins that keep one level at rest, but no timer. This suffices on a board on
  /// which the image must not run.
  void set_up_at_rest() noexcept {
    steps_.set_up();
    directions_.set_up();
    for (const Motor& motor : kBoard.motors) PinSetUp<Bus>::make_output(motor.enable, true);
    for (const Motor& motor : kBoard.second_motors) PinSetUp<Bus>::make_output(motor.enable, true);
    PinSetUp<Bus>::make_output(kBoard.motors_enable, true);
    PinSetUp<Bus>::make_output(kBoard.motor_power, true);
    PinSetUp<Bus>::make_output(kBoard.held_low, false);
    for (const Pin pin : kBoard.outputs) PinSetUp<Bus>::make_output(pin, false);
    for (const Pin pin :
         {kBoard.spindle_enable, kBoard.spindle_direction, kBoard.mist, kBoard.flood}) {
      PinSetUp<Bus>::make_output(pin, false);
    }
  }

  /// Sets which pins are inverted. Main loop, while nothing moves.
  void configure(const Polarity& polarity) noexcept {
    polarity_ = polarity;
    steps_.invert(polarity.steps);
    steps_.drive(0, 0);
    directions_.invert(polarity.directions);
    inputs_.configure(polarity);
    set_motors_enabled(motors_enabled_);
    set_spindle(spindle_enabled_, spindle_reversed_);
    set_coolant(mist_on_, flood_on_);
  }

  // Functions of StepPort.
  void set_direction(AxisMask negative) noexcept {
    directions_.drive(negative.bits, negative.bits);
    timer_.note_edge();
  }
  void raise_steps(AxisMask axes, AxisMask second) noexcept {
    steps_.raise(axes.bits, second.bits);
    timer_.note_edge();
  }
  void lower_steps() noexcept {
    steps_.drive(0, 0);
    timer_.note_pulse_end();
  }
  void set_power(std::uint16_t duty) noexcept { power_.set_duty(duty); }
  void change_outputs(std::uint8_t raise, std::uint8_t lower) noexcept {
    for (std::size_t i = 0; i < kBoard.outputs.size(); ++i) {
      if ((raise >> i & 1U) != 0) PinSetUp<Bus>::write(kBoard.outputs[i], true);
      if ((lower >> i & 1U) != 0) PinSetUp<Bus>::write(kBoard.outputs[i], false);
    }
  }
  /// Does nothing, because no board has an analog output.
  void set_analog(std::uint8_t, std::uint16_t) noexcept {}
  void start_timer() noexcept { timer_.start(); }
  [[nodiscard]] bool probe_contact() const noexcept { return inputs_.probe_contact(); }
  [[nodiscard]] SwitchMask switches() const noexcept { return inputs_.switches(); }

  // Functions of AuxiliaryOutputs.
  void set_spindle(bool enabled, bool counter_clockwise) override {
    spindle_enabled_ = enabled;
    spindle_reversed_ = counter_clockwise;
    PinSetUp<Bus>::write(kBoard.spindle_direction,
                         counter_clockwise != ((polarity_.spindle & 2U) != 0));
    PinSetUp<Bus>::write(kBoard.spindle_enable, enabled != ((polarity_.spindle & 1U) != 0));
  }
  void set_coolant(bool mist, bool flood) override {
    mist_on_ = mist;
    flood_on_ = flood;
    PinSetUp<Bus>::write(kBoard.mist, mist != ((polarity_.coolant & 2U) != 0));
    PinSetUp<Bus>::write(kBoard.flood, flood != ((polarity_.coolant & 1U) != 0));
  }
  void set_digital(std::uint8_t output, bool high) override {
    if (output < kBoard.outputs.size()) PinSetUp<Bus>::write(kBoard.outputs[output], high);
  }
  void set_analog_output(std::uint8_t, std::uint16_t) override {}
  /// Switches the current of the motors. Motors that share an enable pin have current if at least
  /// one of them must have current.
  void set_motors_enabled(std::uint8_t axes) override {
    motors_enabled_ = axes;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const bool high = ((axes ^ polarity_.enables) >> axis & 1U) == 0;
      PinSetUp<Bus>::write(kBoard.motors[axis].enable, high);
      PinSetUp<Bus>::write(kBoard.second_motors[axis].enable, high);
    }
    PinSetUp<Bus>::write(kBoard.motors_enable, (axes != 0) == ((polarity_.enables & 1U) != 0));
  }

  // Function of MachineInputs. Reads all inputs. Also reports an emergency stop if the clock is too
  // slow for the step interrupt, or after refuse_motion(), because nothing may move then.
  [[nodiscard]] InputState read_inputs() override {
    InputState state = inputs_.read();
    if (clocks_.source == ClockSource::kSlow || refuses_motion_) state.emergency_stop = true;
    return state;
  }

  /// Forbids motion until the next restart: from now on the emergency stop reads as pressed.
  void refuse_motion() noexcept { refuses_motion_ = true; }

  [[nodiscard]] constexpr StepTimer<Bus>& timer() { return timer_; }

 private:
  static constexpr CheckedBoard<kBoard> kChecked{};

  static constexpr MotorPins kSteps{step_pins(kBoard.motors), step_pins(kBoard.second_motors)};
  static constexpr MotorPins kDirections{direction_pins(kBoard.motors),
                                         direction_pins(kBoard.second_motors)};

  PinGroup<kSteps, Bus> steps_{};
  PinGroup<kDirections, Bus> directions_{};
  Inputs<kBoard, Bus> inputs_{};
  PowerPin<kBoard, Bus> power_{};
  StepTimer<Bus> timer_{};
  Clocks clocks_{};
  Polarity polarity_{};
  bool refuses_motion_ = false;
  std::uint8_t motors_enabled_ = 0;
  bool spindle_enabled_ = false;
  bool spindle_reversed_ = false;
  bool mist_on_ = false;
  bool flood_on_ = false;
};

}  // namespace hal::stm32f405
