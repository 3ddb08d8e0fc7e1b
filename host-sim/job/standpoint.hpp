#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firmware/machine/machine.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim {

/// The state of a machine at the start of a program: settings, position, offsets and modes. It is a
/// copy, so another thread may use it.
struct Standpoint {
  /// Settings of the machine. $890 is the block delete that is in effect.
  cnc::Settings settings{};
  /// Interpreter with the position, offsets and modes of the machine.
  cnc::gcode::Interpreter reader{};
  std::uint8_t homed = 0;  ///< Homed axes: bit i for axis i.

  bool block_delete() const { return reader.options().block_delete; }
};

[[nodiscard]] Standpoint standpoint_of(const cnc::Machine& machine);

/// Returns the standpoint of a machine of which only the settings are known. Its position is zero,
/// and all modes and offsets have their default values.
[[nodiscard]] Standpoint standpoint_of(const cnc::Settings& settings);

/// Returns a length in mm, or an angle in degrees, rounded to a double.
[[nodiscard]] double in_double(cnc::Coordinate length);
/// Returns a position as a point in mm and degrees, in machine coordinates.
[[nodiscard]] Point point_of(const cnc::Position& position);

/// Returns lines of G-code that set the offsets and modes of the standpoint in any reader at its
/// position, without a motion. Two standpoints with equal lines are equal except for their
/// settings.
[[nodiscard]] std::vector<std::string> state_lines(const Standpoint& standpoint);

}  // namespace sim
