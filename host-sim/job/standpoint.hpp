#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firmware/machine/machine.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim {

/// The machine as a program finds it: settings, position, offsets and modes. A copy, which another
/// thread may use.
struct Standpoint {
  cnc::Settings settings{};          ///< $890 is block delete as it is in effect.
  cnc::gcode::Interpreter reader{};  ///< At the machine's position, with its offsets and modes.
  std::uint8_t homed = 0;            ///< Bit i for axis i.

  bool block_delete() const { return reader.options().block_delete; }
};

[[nodiscard]] Standpoint standpoint_of(const cnc::Machine& machine);

/// The same for a machine of which only the settings are known: at zero, with all modes and offsets
/// as delivered.
[[nodiscard]] Standpoint standpoint_of(const cnc::Settings& settings);

/// mm or degrees, exact to the rounding of a double.
[[nodiscard]] double in_double(cnc::Coordinate length);
/// mm and degrees, machine coordinates.
[[nodiscard]] Point point_of(const cnc::Position& position);

/// Lines of G-code that bring any reader to the offsets and modes of the standpoint, from its
/// position, without a motion; and equal lines mean equal standpoints but for settings.
[[nodiscard]] std::vector<std::string> state_lines(const Standpoint& standpoint);

}  // namespace sim
