#pragma once

#include <cstdint>

namespace hal {

/// Outputs of the machine other than motors and beam. Main loop context; no function blocks or
/// fails.
class AuxiliaryOutputs {
 public:
  /// Sets direction and enable of a spindle; the power output sets its speed. For a laser, only the
  /// enable output has a function.
  virtual void set_spindle(bool enabled, bool counter_clockwise) = 0;
  virtual void set_coolant(bool mist, bool flood) = 0;
  virtual void set_digital(std::uint8_t output, bool high) = 0;
  /// Sets an analog output.
  /// @param value 0 to 65535, which is full scale
  virtual void set_analog_output(std::uint8_t output, std::uint16_t value) = 0;
  /// Switches on the current in the motors of the axes in `axes` (bit 0 is X), and switches it off
  /// in all other motors. A motor without current turns freely, and its position may be lost.
  virtual void set_motors_enabled(std::uint8_t axes) = 0;

 protected:
  ~AuxiliaryOutputs() = default;
};

}  // namespace hal
