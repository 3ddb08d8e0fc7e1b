#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace sim {

class ProbeSurface;

/// The machine around the controller. Positions are in mm (degrees), relative to the position of
/// the motors at power-up.
struct MachineModel {
  /// Height in mm of a conducting plate. It closes the probe circuit when the tool's tip touches it
  /// as Z comes down.
  double probe_plate_z_mm = -10.0;
  /// A surface that closes the probe circuit as well, in machine coordinates; may be null.
  std::shared_ptr<const ProbeSurface> probe_surface{};

  /// Whether the machine has limit switches.
  bool has_switches = true;
  /// Position at which each axis's switch closes, at the end that $23 homes to. An empty value
  /// means a millimetre beyond the travel of a machine that was switched on in its far left lower
  /// corner; endless axes then have no switch.
  std::array<std::optional<double>, 6> switch_mm{};
  /// Distance by which the second motor of an axis is ahead of the first at power-up. The second
  /// motor reaches its own switch earlier by this distance.
  std::array<double, 6> second_ahead_mm{};
  /// Distance that each motor turns on a reversal before its axis follows, in whole steps. An empty
  /// value means the backlash of $160…$165, which the controller knows.
  std::array<std::optional<double>, 6> backlash_mm{};
  /// Whether the play at power-up lies at the other end than after a homing cycle.
  bool backlash_lies_otherwise = false;
  /// Time for which a contact bounces after it opened or closed, in ticks of the step clock.
  std::uint32_t bounce_ticks = 8000;
};

}  // namespace sim
