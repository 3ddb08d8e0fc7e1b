#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

namespace sim {

class ProbeSurface;

/// The machine around the controller. Places are in mm (degrees) from where the
/// motors were at power-up.
struct MachineModel {
  /// Height of a conducting plate that closes the probe circuit; the tool's tip
  /// touches it when Z comes down to it.
  double probe_plate_z_mm = -10.0;
  /// A surface that closes the circuit as well, in machine coordinates; may be null.
  std::shared_ptr<const ProbeSurface> probe_surface{};

  /// Whether there are limit switches at all.
  bool has_switches = true;
  /// Where the switch of each axis closes, at the end that $23 homes to. Left
  /// open, a millimetre beyond the travel of a machine that was switched on in
  /// its far left lower corner; none for endless axes.
  std::array<std::optional<double>, 6> switch_mm{};
  /// How much farther the second motor of an axis has come at power-up, so how
  /// much earlier it gets to its own switch.
  std::array<double, 6> second_ahead_mm{};
  /// How far each motor turns before its axis follows, when it reverses, in whole steps.
  /// Left open, as $160…$165 say: what the controller knows of.
  std::array<std::optional<double>, 6> backlash_mm{};
  /// Whether the play lies otherwise at power-up than a homing cycle would leave it.
  bool backlash_lies_otherwise = false;
  /// How long a contact bounces after it opened or closed, in ticks of the step clock.
  std::uint32_t bounce_ticks = 8000;
};

}  // namespace sim
