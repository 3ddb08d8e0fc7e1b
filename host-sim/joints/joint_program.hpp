#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim::joints {

struct JointOptions {
  double tip_tolerance_mm = 1.0e-3;  ///< Tolerance for the tip between the ends of a move, above 0.
  Point zero{};                      ///< Machine position of the program's zero, X Y Z in mm.
  int decimals = 4;  ///< Digits after the decimal point of X, Y and Z; angles have one more.
};

struct JointFigures {
  std::size_t motions = 0;  ///< Number of lines and arcs of the program.
  std::size_t moves = 0;    ///< Number of written lines that move the axes.
  /// Greatest distance of the tip from its path, before digits are cut off.
  double error_mm = 0.0;
  double feed_s = 0.0;             ///< Total time of all feeds, in seconds.
  std::optional<Bounds> bounds{};  ///< Extent of the axes' positions, machine coordinates.
};

struct JointProgram {
  std::string text;
  JointFigures figures;
};

/// Returns a program under G43.4 as moves of the axes themselves, for a controller without control
/// of the tool's centre. The moves are straight, in machine coordinates, mm and degrees, with
/// inverse time feed (G93). Beam, spindle, coolant, dwells, stops and comments are those of the
/// program.
/// @param settings settings $900 to $917 of the machine that carries the tool
/// @param file name of the program's file, for errors
/// Throws std::invalid_argument with the line for words that cannot be converted, for a tilt beyond
/// $916 and $917, and for a machine without five axes.
[[nodiscard]] JointProgram joint_program(std::string_view text,
                                         const std::string& file,
                                         const cnc::Settings& settings,
                                         const JointOptions& options);

}  // namespace sim::joints
