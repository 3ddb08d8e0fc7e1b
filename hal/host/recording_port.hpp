#pragma once

#include <array>
#include <cstdint>

#include "hal/interface/auxiliary_outputs.hpp"
#include "hal/interface/machine_inputs.hpp"
#include "hal/interface/step_port.hpp"

namespace hal::host {

/// Pins of a controller without hardware. Stores the state of the pins for the program that
/// simulates the machine. Used by one thread only.
class RecordingPort final : public AuxiliaryOutputs, public MachineInputs {
 public:
  static constexpr std::size_t kMotors = 6;

  // Functions of StepPort.
  void set_direction(AxisMask negative) noexcept { negative_ = negative; }
  void raise_steps(AxisMask axes, AxisMask second) noexcept {
    count_steps(axes, position);
    if (second.bits != 0) count_steps(second, second_position);
    changed = true;
  }
  void lower_steps() noexcept {}
  void set_power(std::uint16_t duty) noexcept {
    power = duty;
    changed = true;
  }
  void change_outputs(std::uint8_t raise, std::uint8_t lower) noexcept {
    digital = static_cast<std::uint8_t>((digital | raise) & ~lower);
  }
  void set_analog(std::uint8_t channel, std::uint16_t value) noexcept {
    if (channel < analog.size()) analog[channel] = value;
  }
  void start_timer() noexcept { timer_started = true; }
  [[nodiscard]] bool probe_contact() const noexcept { return probe; }
  [[nodiscard]] SwitchMask switches() const noexcept { return limits; }

  // Functions of AuxiliaryOutputs.
  void set_spindle(bool enabled, bool counter_clockwise) override {
    spindle_enabled = enabled;
    spindle_reversed = counter_clockwise;
  }
  void set_coolant(bool with_mist, bool with_flood) override {
    mist = with_mist;
    flood = with_flood;
  }
  void set_digital(std::uint8_t output, bool high) override {
    const auto bit = static_cast<std::uint8_t>(1U << output);
    change_outputs(high ? bit : std::uint8_t{0}, high ? std::uint8_t{0} : bit);
  }
  void set_analog_output(std::uint8_t output, std::uint16_t value) override {
    set_analog(output, value);
  }

  void set_motors_enabled(std::uint8_t axes) override { motors_enabled = axes; }

  // Function of MachineInputs.
  [[nodiscard]] InputState read_inputs() override {
    InputState state = panel;
    state.probe = probe;
    state.limits = limits.first;
    state.second_limits = limits.second;
    return state;
  }

  /// Sets the pins to their state after a chip's reset: all outputs low, and no current in the
  /// motors. The motor positions and the states of the switches stay.
  void reset() {
    negative_ = {};
    analog = {};
    power = 0;
    digital = 0;
    set_spindle(false, false);
    set_coolant(false, false);
    motors_enabled = 0;
    timer_started = false;
    changed = true;
  }

  // State of the machine: outputs that the machine reads, and inputs that the machine sets.
  /// Position of each first motor, in steps since power-up.
  std::array<std::int32_t, kMotors> position{};
  /// Position of each second motor, in steps since power-up.
  std::array<std::int32_t, kMotors> second_position{};
  std::array<std::uint16_t, 4> analog{};
  std::uint16_t power = 0;
  std::uint8_t digital = 0;
  bool spindle_enabled = false;
  bool spindle_reversed = false;
  bool mist = false;
  bool flood = false;
  /// Whether a motor has stepped or the power has changed; the reader clears it.
  bool changed = false;
  /// Whether a start of the timer was requested; the reader clears it.
  bool timer_started = false;
  bool probe = false;
  SwitchMask limits{};
  std::uint8_t motors_enabled = 0;  ///< Bit i is 1 if the motor of axis i has current.
  InputState panel{};               ///< Door and buttons, set by the simulation of the operator.

 private:
  using Steps = std::array<std::int32_t, kMotors>;

  /// For each mask of motors: 1 for each motor in the mask, 0 for each other motor.
  static constexpr auto kOnes = [] {
    std::array<Steps, 1U << kMotors> ones{};
    for (std::size_t mask = 0; mask < ones.size(); ++mask) {
      for (std::size_t axis = 0; axis < kMotors; ++axis) {
        ones[mask][axis] = static_cast<std::int32_t>(mask >> axis & 1);
      }
    }
    return ones;
  }();

  /// Counts the steps of all motors without a branch for each motor, because the processor could
  /// not predict such branches. A lookup table is faster than a shift for each motor.
  void count_steps(AxisMask axes, Steps& steps) const noexcept {
    const Steps& forward = kOnes[axes.bits & ~negative_.bits & (kOnes.size() - 1)];
    const Steps& backward = kOnes[axes.bits & negative_.bits & (kOnes.size() - 1)];
#pragma GCC unroll 6
    for (std::size_t axis = 0; axis < kMotors; ++axis)
      steps[axis] += forward[axis] - backward[axis];
  }

  AxisMask negative_{};
};

static_assert(StepPort<RecordingPort>);

}  // namespace hal::host
