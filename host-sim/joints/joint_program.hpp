#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/curve.hpp"

namespace sim::joints {

struct JointOptions {
  double tip_tolerance_mm = 1.0e-3;  ///< Greatest deviation of the tip from its path, > 0.
  Point zero{};                      ///< Machine position of the program's zero, X Y Z in mm.
  int decimals = 4;  ///< Digits after the decimal point of X, Y and Z; angles have one digit more.
};

struct JointFigures {
  std::size_t motions = 0;  ///< Number of lines and arcs in the source program.
  std::size_t moves = 0;    ///< Number of written lines that move the axes.
  /// Greatest distance of the tip from its path, before coordinates are rounded to the written
  /// digits.
  double error_mm = 0.0;
  double feed_s = 0.0;             ///< Total time of all feeds, in seconds.
  std::optional<Bounds> bounds{};  ///< Extent of the axis positions, machine coordinates.
};

struct JointProgram {
  std::string text;
  JointFigures figures;
};

/// Converts a program with G43.4 to moves of the machine's axes, for a controller that does not
/// support G43.4 (tool centre point control). The moves are straight, in machine coordinates, mm
/// and degrees, with inverse time feed (G93). Copies comments, and words for beam, spindle,
/// coolant, dwells and stops.
/// @param settings settings of the five-axis machine; $900 to $917 are used
/// @param file name of the program's file, for error messages
/// Throws std::invalid_argument, with the line number, for words that cannot be converted and for a
/// tilt outside of the range $916 to $917. Throws std::invalid_argument if the settings do not
/// describe a five-axis machine.
[[nodiscard]] JointProgram joint_program(std::string_view text,
                                         const std::string& file,
                                         const cnc::Settings& settings,
                                         const JointOptions& options);

}  // namespace sim::joints
