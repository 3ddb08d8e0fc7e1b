#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim::joints {

struct JointOptions {
  double tip_tolerance_mm = 1.0e-3;  ///< Of the tip between the ends of a move, above 0.
  Point zero{};                      ///< Machine place of the program's zero, X Y Z in mm.
  int decimals = 4;  ///< Digits after the point of X, Y and Z; angles have one more.
};

struct JointFigures {
  std::size_t motions = 0;         ///< Lines and arcs of the program.
  std::size_t moves = 0;           ///< Lines of the axes.
  double error_mm = 0.0;           ///< Greatest of the tip, before digits are cut off.
  double feed_s = 0.0;             ///< Time of all feeds.
  std::optional<Bounds> bounds{};  ///< Places of the axes, machine coordinates.
};

struct JointProgram {
  std::string text;
  JointFigures figures;
};

/// Returns a program under G43.4 as moves of the axes themselves, for a controller without control
/// of the tool's centre: straight moves in machine coordinates, mm and degrees, with the inverse of
/// their time (G93). Beam, spindle, coolant, dwells, stops and comments are those of the program.
/// @param settings of the machine that carries the tool, $900 to $917
/// @param file named in errors
/// Throws std::invalid_argument with the line for what cannot be carried over, for a tilt beyond
/// $916 and $917, and for a machine without five axes.
[[nodiscard]] JointProgram joint_program(std::string_view text,
                                         const std::string& file,
                                         const cnc::Settings& settings,
                                         const JointOptions& options);

}  // namespace sim::joints
