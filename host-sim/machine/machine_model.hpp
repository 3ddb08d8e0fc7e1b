#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace sim {

class ProbeSurface;

/// Model of the machine around the controller. Positions are in mm (degrees for A, B and C),
/// relative to the position of the motors at power-up.
struct MachineModel {
  /// Height of a conducting plate, mm. The plate closes the probe circuit when the tool's tip
  /// touches it from above.
  double probe_plate_z_mm = -10.0;
  /// A second surface that closes the probe circuit, in machine coordinates; may be null.
  std::shared_ptr<const ProbeSurface> probe_surface{};

  /// Whether the machine has limit switches.
  bool has_switches = true;
  /// For each axis, the position at which its switch closes, at the end to which $23 homes. An
  /// empty value means 1 mm beyond the travel, for a machine that was switched on at the lower end
  /// of all its axes. An endless axis with an empty value has no switch.
  std::array<std::optional<double>, 6> switch_mm{};
  /// For each axis, the distance by which the second motor is ahead of the first at power-up. The
  /// second motor reaches its own switch earlier by this distance.
  std::array<double, 6> second_ahead_mm{};
  /// For each axis, the distance that the motor turns on a reversal before the axis follows;
  /// rounded to full steps. An empty value means the backlash of $160…$165, which the controller
  /// knows.
  std::array<std::optional<double>, 6> backlash_mm{};
  /// Whether each axis is, at power-up, at the end of its play that is opposite to its end after a
  /// homing cycle.
  bool backlash_lies_otherwise = false;
  /// Duration of the bouncing of a contact after it opens or closes, in ticks of the step clock.
  std::uint32_t bounce_ticks = 8000;
};

}  // namespace sim
