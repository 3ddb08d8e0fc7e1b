#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firmware/machine/machine.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim {

/// State of the machine when a program begins: settings, position, offsets and modes. It is a copy,
/// which another thread may use.
struct Standpoint {
  cnc::Settings settings{};  ///< $890 is block delete as it is in effect.
  /// Interpreter at the machine's position, with its offsets and modes.
  cnc::gcode::Interpreter reader{};
  std::uint8_t homed = 0;  ///< Homed axes: bit i for axis i.

  bool block_delete() const { return reader.options().block_delete; }
};

[[nodiscard]] Standpoint standpoint_of(const cnc::Machine& machine);

/// Returns the standpoint of a machine of which only the settings are known: at zero, with all
/// modes and offsets as delivered.
[[nodiscard]] Standpoint standpoint_of(const cnc::Settings& settings);

/// Returns a length in mm or degrees, exact to the rounding of a double.
[[nodiscard]] double in_double(cnc::Coordinate length);
/// Returns a position in mm and degrees, machine coordinates.
[[nodiscard]] Point point_of(const cnc::Position& position);

/// Returns lines of G-code that bring any reader to the offsets and modes of the standpoint, from
/// its position, without a motion. Equal lines mean that two standpoints are equal except for their
/// settings.
[[nodiscard]] std::vector<std::string> state_lines(const Standpoint& standpoint);

}  // namespace sim
