#pragma once

#include <cstdint>

namespace hal {

/// What the machine switches besides motors and beam. Main loop context, none
/// of it blocks or fails.
class AuxiliaryOutputs {
 public:
  /// Direction and enable of a spindle; its speed is the power output. For a
  /// laser the enable only.
  virtual void set_spindle(bool enabled, bool counter_clockwise) = 0;
  virtual void set_coolant(bool mist, bool flood) = 0;
  virtual void set_digital(std::uint8_t output, bool high) = 0;
  /// @param value 65535 is full scale.
  virtual void set_analog_output(std::uint8_t output, std::uint16_t value) = 0;
  /// Current in the motors of these axes, a bit each from X on, and in no others. Without it they
  /// turn freely and may lose their place.
  virtual void set_motors_enabled(std::uint8_t axes) = 0;

 protected:
  ~AuxiliaryOutputs() = default;
};

}  // namespace hal
